#include "app/shell/screen.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/paint/label_painter.h"
#include "app/picture/screen_box.h"
#include "app/stage/stage_layout.h"
#include "app/widgets/controls.h"
#include "app/widgets/focus.h"
#include "app/widgets/pointing.h"
#include "app/widgets/tooltips.h"
#include "app/workbench/bars.h"
#include "app/workbench/dialogs.h"
#include "app/workbench/motor_control.h"
#include "app/workbench/plot_pieces.h"

namespace ghostforce {
namespace {

Image cut_out(const Image& image, int left, int top, int width, int height) {
  Image part{std::clamp(width, 1, image.width - left), std::clamp(height, 1, image.height - top), {}};
  part.rgb.reserve(3U * static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height));
  for (int y = top; y < top + part.height; ++y) {
    const auto begin = image.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * image.width + left);
    part.rgb.insert(part.rgb.end(), begin, begin + 3 * static_cast<std::ptrdiff_t>(part.width));
  }
  return part;
}

// As clickers have it.
Theme black_theme(const Theme& theme) {
  Theme black = theme;
  black.background = rgb(0x000000);
  return black;
}

}  // namespace

Screen::Screen(Window& window, Part part)
    : window_(window),
      part_(part),
      drawing_(std::make_unique<Drawing>(window.fonts())),
      measure_(measure_with(window.fonts())),
      workbench_(window.fonts()) {}

void Screen::restart_drawing() {
  drawing_ = std::make_unique<Drawing>(window_.fonts());
}

void Screen::take_keys(const Session& session, const ActionSink& apply) {
  keyboard_.take(window_, session, apply);
}

void Screen::draw(Session& session, const ActionSink& apply, const ShownMoment& moment, const History& history,
                  const LoopReading& loop, double interval_s) {
  if (window_.pixel_width() <= 0 || window_.pixel_height() <= 0) return;  // minimised
  // The style must not change within a frame.
  apply_appearance(session);
  const Face face = session.face;
  window_.frame(interval_s, [&] {
    draw_everything(session, apply, moment, history, loop, {part_, true, interval_s});
    // What the person did in this frame may have led to the other face, which is not composed before the next.
    if (audience_ && session.face == face) prepare_for_audience(session, moment, history, loop, interval_s);
  });
  if (audience_) audience_->window->show();
}

void Screen::show_to(std::unique_ptr<AudienceWindow> audience) {
  audience_.reset();
  if (audience) audience_ = std::make_unique<Audience>(Audience{std::move(audience)});
}

void Screen::prepare_for_audience(const Session& session, const ShownMoment& moment, const History& history,
                                  const LoopReading& loop, double interval_s) {
  const Theme& theme = styled_theme_;
  const Vector<2> size = audience_->window->size();
  if (session.stage.is_black || size.x <= 0.0 || size.y <= 0.0) {
    return audience_->window->prepare({}, black_theme(theme));
  }
  const StageFrame frame{.shown = moment,
                         .history = history,
                         .loop = loop,
                         .theme = theme,
                         .measure = measure_,
                         .size = size,
                         .scale = session.appearance.scale,
                         .has_controls = false};
  audience_->window->prepare({stage_.pane_apart(session, frame, audience_->labels, interval_s)}, theme);
}

void Screen::advance(const Session& session, double interval_s) noexcept {
  if (session.face == Face::stage) stage_.advance(interval_s);
}

bool Screen::is_moving(const Session& session) const noexcept {
  if (audience_ && audience_->labels.is_moving()) return true;
  return Keyboard::is_waiting(window_) || (session.face == Face::stage ? stage_.is_moving() : workbench_.is_moving());
}

Image Screen::picture(const Session& session, const ShownMoment& moment, const History& history,
                      const LoopReading& loop, Part part, int density) {
  // Nobody can take hold of a picture or follow its hints.
  Session copy = session;
  copy.hint.reset();
  copy.has_handles = false;
  const Image image = window_.picture_of(density, [&] {
    draw_everything(copy, [](const Action&) {}, moment, history, loop,
                    {session.face == Face::stage ? part : part_, false, 0.0});
  });
  if (part == Part::window) return image;
  const auto pixels = [&](double points) {
    return static_cast<int>(std::lround(points * image.width / static_cast<double>(ImGui::GetIO().DisplaySize.x)));
  };
  return cut_out(image, pixels(static_cast<double>(scene_corner_.x)), pixels(static_cast<double>(scene_corner_.y)),
                 pixels(scene_size_.x), pixels(scene_size_.y));
}

void Screen::apply_appearance(const Session& session) {
  scale_ = session.appearance.scale * static_cast<double>(window_.display_scale());
  const ImVec2 density = ImGui::GetIO().DisplayFramebufferScale;
  const Vector<2> size{window_.pixel_width() / static_cast<double>(density.x),
                       window_.pixel_height() / static_cast<double>(density.y)};
  const auto scale = static_cast<float>(session.face == Face::stage ? scale_over_stage(size, scale_) : scale_);
  if (shown_theme(session) == styled_theme_ && scale == styled_scale_) return;
  styled_theme_ = shown_theme(session);
  styled_scale_ = scale;
  apply_style(styled_theme_, scale);
  apply_plot_style(styled_theme_, scale);
}

void Screen::draw_everything(Session& session, const ActionSink& apply, const ShownMoment& moment,
                             const History& history, const LoopReading& loop, const Frame& frame) {
  const Theme& theme = styled_theme_;
  // A control is held before it changes anything, and let go of after all of it.
  const ActionSink apply_held = [&](const Action& action) {
    if (!session.is_editing && ImGui::IsAnyItemActive()) apply(HoldControl{true});
    apply(action);
  };
  const WidgetMemory memory(session);
  const PanelContext context{session, apply_held,      memory,        moment.snapshot,   moment.settings,  loop,
                             theme,   window_.fonts(), styled_scale_, drawing_->gallery, drawing_->lessons};
  if (frame.is_live) keep_tooltips_from_drags();
  // What a person does in this frame may lead to the other one.
  const bool is_on_stage = session.face == Face::stage;
  if (is_on_stage) {
    draw_stage(session, context, moment, history, frame);
  } else {
    workbench_.draw(session, context, {moment, history, measure_, frame.part, frame.is_live, frame.interval_s});
    panes_ = workbench_.panes();
    scene_corner_ = workbench_.scene_corner();
    scene_size_ = workbench_.scene_size();
  }
  if (frame.is_live) {
    if (const bool is_held = ImGui::IsAnyItemActive(); is_held != session.is_editing) apply(HoldControl{is_held});
    hints_.follow(session);
  }
  const double text_scale = text_scale_of(session.face, scale_, theme);
  const bool is_blank = session.stage.is_black && frame.is_live;
  if (is_blank && !session.has_audience && session.face == Face::stage) {
    drawing_->painter.paint({}, black_theme(theme), scene_corner_, text_scale, window_.pixel_width(),
                            window_.pixel_height());
  } else {
    drawing_->painter.paint(panes_, theme, scene_corner_, text_scale, window_.pixel_width(), window_.pixel_height());
  }
  if (!frame.is_live) return;
  const Vector<2> corner = vector_of(scene_corner_);
  const ScreenBox scene{corner, corner + scene_size_};
  if (is_blank && session.has_audience) draw_blank_words(context, scene);
  draw_shader_problem(context, scene);
  // On the stage between its rows of buttons, and beside its menu.
  ScreenBox room = is_on_stage ? stage_.picture().scene : scene;
  if (const auto& menu = stage_.picture().menu; is_on_stage && menu) room.most.x = menu->least.x;
  // Fit and Reset stay free: where the window is narrow, a notice is beside them.
  if (const auto& tools = stage_.picture().tools; is_on_stage && tools) room.least.x = tools->most.x;
  draw_notice(context, room);
  const std::optional<Vector<2>> hand =
      is_on_stage ? std::optional(to_screen(stage_.picture().pane.camera, session.goal)) : std::nullopt;
  draw_dialog(context, hand);
  draw_focus_ring(theme, styled_scale_);
}

void Screen::draw_stage(Session& session, const PanelContext& context, const ShownMoment& moment,
                        const History& history, const Frame& frame) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  scene_corner_ = {0.0F, 0.0F};
  const float notes = frame.is_live && context.session.has_audience ? notes_height(size.y) : 0.0F;
  scene_size_ = {static_cast<double>(size.x), static_cast<double>(size.y - notes)};
  const StageFrame stage_frame{.shown = moment,
                               .history = history,
                               .loop = context.loop,
                               .theme = context.theme,
                               .measure = measure_,
                               .size = scene_size_,
                               .scale = scale_,
                               .has_controls = frame.part == Part::window};
  if (!frame.is_live) {
    panes_ = {stage_.still(context.session, stage_frame).pane};
    return;
  }
  begin_screen("stage");
  stage_.update(session, context.apply, stage_frame, keyboard_.has_pressed(), frame.interval_s);
  draw_motor_frame(context);
  const Vector<2>& end = stage_.picture().scene.most;  // above the buttons
  if (notes > 0.0F) {
    begin_piece("notes", {{0.0F, size.y - notes}, {size.x, notes}}, fixed_window);
    draw_notes(context);
    ImGui::EndChild();
  }
  if (context.session.stage.is_black && !context.session.has_audience) {
    draw_motor_words(context);
  } else {
    draw_replay_place(context, imgui_vector(end), static_cast<float>(stage_.picture().unit));
  }
  ImGui::End();
  panes_ = {stage_.compose(context.session, stage_frame, frame.interval_s).pane};
}

StageReading Screen::stage_reading(const Session& session, const ShownMoment& moment, const History& history,
                                   const LoopReading& loop) const {
  return stage_.reading(session, {moment, history, loop, shown_theme(session), measure_, scene_size_, scale_});
}

std::vector<Pane> Screen::panes_for_file(const Session& session, const ShownMoment& moment, const History& history,
                                         const LoopReading& loop, const MeasureText& measure) const {
  if (session.face == Face::workbench) {
    return workbench_.panes_for_file(session, moment, history, loop, measure, scale_);
  }
  return {stage_
              .still(session, {.shown = moment,
                               .history = history,
                               .loop = loop,
                               .theme = shown_theme(session),
                               .measure = measure,
                               .size = scene_size_,
                               .scale = scale_,
                               .has_controls = false})
              .pane};
}

}  // namespace ghostforce
