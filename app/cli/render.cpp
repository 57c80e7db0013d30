// ghostforce render: the picture of a scene at one moment, drawn offscreen by the same screen as the window's.
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/base/failure.h"
#include "app/base/progress.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/cli/command.h"
#include "app/cli/lesson_options.h"
#include "app/cli/option.h"
#include "app/cli/picture_options.h"
#include "app/files/clip_file.h"
#include "app/files/output_file.h"
#include "app/files/png_writer.h"
#include "app/files/scene_file.h"
#include "app/paint/vector/vector_painter.h"
#include "app/shell/desktop/offscreen.h"
#include "app/state/permit.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "core/scene.h"

namespace ghostforce {
namespace {

struct RenderOptions {
  SceneOptions scene;
  PictureOptions picture;
  std::string output;
  std::string json;
  std::optional<double> at_s;
  std::string size = "1280x800";
  std::string part;  // empty: what the file can hold
  std::string compare;
  std::optional<std::string> clip;  // FROM:TO:FPS; empty: one picture
  LessonOptions lesson;
  std::optional<int> step;    // of the lesson, from 1
  std::optional<int> answer;  // of that step, from 1
  std::optional<Renderer> renderer;
};

void apply_size(const std::string& text, PictureRequest& request) {
  char rest = '\0';
  const bool good = std::sscanf(text.c_str(), "%5dx%5d%c", &request.width, &request.height, &rest) == 2;
  const auto fits = [](int length) { return length >= smallest_picture && length <= largest_picture; };
  if (good && fits(request.width) && fits(request.height)) return;
  throw Failure(ExitCode::wrong_call,
                fmt::format("--size {}: give WIDTHxHEIGHT in pixels, each {} to {}, for example 1280x800",
                            quoted_text(text), smallest_picture, largest_picture));
}

// `lesson`: null if there is none.
void apply_lesson(const RenderOptions& options, const std::shared_ptr<const Lesson>& lesson, PictureRequest& request) {
  request.language = options.lesson.wanted("en", lesson);
  if (!lesson) return;
  LessonPicture picture{.lesson = lesson, .step = static_cast<std::size_t>(options.step.value_or(1) - 1)};
  if (options.answer) picture.answer = static_cast<std::size_t>(*options.answer);
  if (const std::string problem = find_problem(picture); !problem.empty()) {
    throw Failure(ExitCode::wrong_call, problem);
  }
  show_lesson_in(request, std::move(picture));
}

// The stage shows one strategy, as a person has it in the hand.
void refuse_all_on_stage(const RenderOptions& options, Face face) {
  const bool is_stage = face == Face::stage;
  const bool has_many = options.picture.strategy == every_strategy || !options.compare.empty();
  if (!is_stage || !has_many) return;
  throw Failure(
      ExitCode::wrong_call,
      "the stage shows one strategy at a time; name one with --strategy, leave out --compare, or use --view workbench");
}

// A scene of format 2 is on the stage, where its device can be moved, unless something else was asked for.
Face face_of(const RenderOptions& options, const Scene& scene) {
  const Face face = options.picture.face_or(is_general(scene.settings) ? Face::stage : Face::workbench);
  refuse_all_on_stage(options, face);
  return face;
}

void refuse_mode_of_other_scenes(const PictureRequest& request) {
  if (request.mode == StageMode::none) return;
  const auto refusal = permit(session_of(request.scene), ToggleMode{request.mode});
  if (!refusal) return;
  throw Failure(ExitCode::wrong_call,
                fmt::format("--mode {}: {}", stage_mode_name(request.mode), english_stage.refusals.*refusal->words));
}

PictureRequest request_of(const RenderOptions& options) {
  PictureRequest request;
  apply_size(options.size, request);
  request.scene = options.scene.load();
  tell_of_doubtful_times(request.scene);
  tell_of_doubtful_path(request.scene);
  request.at_s = options.at_s;
  request.renderer = options.renderer;
  request.face = face_of(options, request.scene);
  request.mode = options.picture.stage_mode();
  refuse_mode_of_other_scenes(request);
  const bool is_clip_of_stage = options.clip && request.face == Face::stage && options.part.empty();
  const bool is_scene = options.part == "scene" || vector_format_of(options.output) || is_clip_of_stage;
  request.part = is_scene ? Part::scene : Part::window;
  apply_strategy_word(options.picture.strategy, request);
  if (const auto compare = find_compare(options.compare)) request.options.compare = *compare;
  options.picture.apply_appearance(request.appearance);
  apply_lesson(options, options.lesson.load(), request);
  return request;
}

// Panels and bars are drawn in pixels.
void refuse_window_as_vectors(const RenderOptions& options) {
  if (options.part != "window" || !vector_format_of(options.output)) return;
  throw Failure(
      ExitCode::wrong_call,
      fmt::format(
          "--part window: panels are drawn in pixels, so {} cannot contain them; leave out --part, or write a .png",
          quoted_text(options.output, longest_path)));
}

// Cairo draws them.
void refuse_renderer_for_vectors(const RenderOptions& options) {
  if (!options.renderer || !vector_format_of(options.output)) return;
  throw Failure(ExitCode::wrong_call,
                fmt::format("--renderer {}: SVG and PDF are drawn without OpenGL; leave it out, or write a .png",
                            entry_of(*options.renderer).name));
}

struct Rendering {
  std::string file;
  std::vector<Pane> panes;
  Vector<2> corner;  // of the scene in the picture [points]
};

Rendering paint_moment(const PictureRequest& request, const Moment& moment, const std::string& output) {
  const auto format = vector_format_of(output);
  if (!format) {
    Drawing drawing = draw_moment(request, moment);
    return {png_bytes(drawing.image, picture_texts(set_up_of(request, moment))), std::move(drawing.panes),
            drawing.corner};
  }
  const Vector<2> size{static_cast<double>(request.width), static_cast<double>(request.height)};
  const Theme& theme = *request.appearance.theme;
  std::vector<Pane> panes = compose_moment(request, moment, size, measure_vector_text);
  std::string file = paint_vector(panes, theme, size, text_scale_of(request.face, request.appearance.scale, theme),
                                  *format, picture_title(request.scene.title, set_up_of(request, moment)));
  return {std::move(file), std::move(panes), Vector<2>(0.0)};
}

// FROM:TO:FPS, in seconds and pictures a second. Throws Failure(wrong_call).
ClipTimes clip_times_from(std::string_view text) {
  std::string_view rest = text;
  const std::optional<double> from = number_in<double>(trimmed(take_until(rest, ':')));
  const std::optional<double> to = number_in<double>(trimmed(take_until(rest, ':')));
  const std::optional<int> frames_per_second = number_in<int>(trimmed(rest));
  const auto refuse = [&](std::string_view why) {
    return Failure(ExitCode::wrong_call,
                   fmt::format("--clip {}: {}; give FROM:TO:FPS, for example 0:3:30", quoted_text(text), why));
  };
  const auto is_time = [](const std::optional<double>& time) { return time && *time >= 0.0 && *time <= longest_s; };
  if (!is_time(from) || !is_time(to)) throw refuse("FROM and TO are times in seconds");
  if (!(*from < *to)) throw refuse("TO must be later than FROM");
  if (!frames_per_second || *frames_per_second < 1 || *frames_per_second > most_frames_per_second) {
    throw refuse(fmt::format("FPS is a whole number of pictures a second, 1 to {}", most_frames_per_second));
  }
  return {*from, *to, *frames_per_second};
}

int render_clip(const RenderOptions& options, const PictureRequest& request) {
  const ClipTimes times = clip_times_from(*options.clip);
  const ClipShape shape{request.width, request.height, times.frames_per_second};
  check_clip_limits(frame_count(times), shape);
  PictureRequest last = request;
  last.at_s = time_of_frame(times, frame_count(times) - 1);
  const SetUp set_up = set_up_of(last, simulate_to_moment(last));
  ClipFile file(options.output, shape, set_up_line(set_up));  // ffmpeg wants to know it before the first picture
  Progress progress("drawing the clip", frame_count(times), true);
  std::int64_t drawn = 0;
  draw_clip(request, times, [&](const Image& image) {
    file.add(image);
    progress.at(++drawn);
  });
  file.commit();
  return static_cast<int>(ExitCode::done);
}

int render(const RenderOptions& options) {
  if (!options.clip) refuse_window_as_vectors(options);
  refuse_renderer_for_vectors(options);
  const PictureRequest request = request_of(options);
  if (options.clip) return render_clip(options, request);
  OutputFile picture_file(options.output);
  std::optional<OutputFile> json_file;
  if (!options.json.empty()) json_file.emplace(options.json);

  const Moment moment = simulate_to_moment(request);
  const Rendering picture = paint_moment(request, moment, options.output);
  picture_file.write(picture.file);
  if (json_file) json_file->write(describe_picture(request, moment, picture.panes, picture.corner).dump(1) + "\n");
  picture_file.commit();
  if (json_file) json_file->commit();
  return static_cast<int>(ExitCode::done);
}

}  // namespace

std::function<int()> attach_render(CLI::App& command, FileOptions& files) {
  const auto options = std::make_shared<RenderOptions>();
  options->scene.attach(command, files, false);
  files.writes(add_option(command, "-o,--output FILE", options->output,
                          "The file to write, whole or not at all: vectors for .svg and .pdf, a PNG for any other "
                          "name; - is standard output; for a clip, see --clip")
                   ->required());
  add_option(command, "--at T", options->at_s, "The time to show [s]; default: the scene's duration")
      ->check(number_between(0.0, longest_s, "s"));
  add_option(command, "--size WxH", options->size,
             "Size in pixels, or in points for SVG and PDF, 64 to 4096 each way; default: 1280x800");
  add_option(command, "--part PART", options->part,
             "window, with panels and bars, or scene, alone; default: window, but scene for SVG and PDF, and for "
             "clips of the stage")
      ->check(one_of({"window", "scene"}));
  options->picture.attach(command, true);
  add_option(command, "--compare MODE", options->compare,
             "overlay, side-by-side or active-only; default: overlay with --strategy all, else active-only")
      ->check(one_of(names_of(compare_catalog())));
  command
      .add_flag_callback(
          "--landscape", [options] { options->picture.mode = stage_mode_name(StageMode::landscape); },
          "The map of all walls and hands: short for --mode landscape")
      ->excludes(command.get_option("--mode"));
  CLI::Option* const json =
      files.writes(add_option(command, "--json FILE", options->json, "Also write what was drawn, as JSON"));
  add_option(
      command, "--clip FROM:TO:FPS", options->clip,
      "A clip instead of one picture: from one time to another [s] with so many pictures a second, 1 to 60, as an "
      "animated .png, or as .mp4 or .webm if ffmpeg is installed")
      ->excludes(command.get_option("--at"))
      ->excludes(json);
  options->lesson.attach(command, files, "en");
  CLI::Option* const lesson = command.get_option("--lesson");
  add_option(command, "--step N", options->step, "The step of the lesson, from 1; default: 1")
      ->needs(lesson)
      ->check(whole_number_from(1));
  add_option(command, "--answer K", options->answer,
             "After an answer to its question: the number of one of the answers; for a guess or a task, 1 for a "
             "right one and 2 for another")
      ->needs(lesson)
      ->check(whole_number_from(1));
  attach_renderer(command, options->renderer);
  // Lessons bring their own.
  options->scene.option->default_str("");
  return [options, &command] {
    options->lesson.refuse_contradictions(command);
    if (!options->scene.is_named() && options->lesson.name.empty()) {
      throw Failure(ExitCode::wrong_call, "SCENE is required: name a scene, as in 'ghostforce render wall45 -o F.png'");
    }
    return render(*options);
  };
}

}  // namespace ghostforce
