// Every Action by name, with its fields: what a line of a session says (session_file.h). A new Action has its row here;
// one that is missing does not compile. Constant; any thread.
#pragma once

#include <string_view>
#include <tuple>
#include <variant>

#include "app/state/action.h"

namespace ghostforce {

// A value inside an object, by the members that lead to it.
template <typename... Path>
struct LineField {
  std::string_view name;
  std::tuple<Path...> path;

  constexpr auto& of(auto& object) const {
    return std::apply(
        [&](auto... members) -> auto& { return (object.*....*members); }, path);
  }
};

template <typename Object, typename... Fields>
struct LineKind {
  using Of = Object;
  std::string_view name;
  std::tuple<Fields...> fields;
};

template <typename... Path>
constexpr LineField<Path...> line_field(std::string_view name, Path... path) {
  return {name, {path...}};
}

template <typename Object, typename... Fields>
constexpr LineKind<Object, Fields...> line_kind(std::string_view name, Fields... fields) {
  return {name, {fields...}};
}

inline constexpr auto action_kinds = std::tuple{
    // Hand, motor and wall
    line_kind<MoveHandBy>("move-hand-by", line_field("by", &MoveHandBy::by)),
    line_kind<MoveHandTo>("move-hand-to", line_field("goal", &MoveHandTo::goal)),
    line_kind<LetGoOfHand>("let-go-of-hand"),
    line_kind<MoveGuessTo>("move-guess-to", line_field("guess", &MoveGuessTo::guess)),
    line_kind<TurnMotorTo>("turn-motor-to", line_field("angle", &TurnMotorTo::angle)),
    line_kind<TurnWallTo>("turn-wall-to", line_field("angle", &TurnWallTo::angle)),
    line_kind<GoToLandscapePoint>("go-to-landscape-point",
                                  line_field("angle", &GoToLandscapePoint::point, &LandscapePoint::angle),
                                  line_field("kappa", &GoToLandscapePoint::point, &LandscapePoint::kappa)),
    line_kind<TurnMotorBy>("turn-motor-by", line_field("degrees", &TurnMotorBy::degrees)),
    line_kind<TurnWallToLargestDrift>("turn-wall-to-largest-drift"),
    line_kind<MovePart>("move-part", line_field("part", &MovePart::part), line_field("to", &MovePart::to)),
    line_kind<SwitchMotor>("switch-motor"),
    line_kind<TurnRatio>("turn-ratio", line_field("factor", &TurnRatio::factor)),
    // Strategies
    line_kind<ChooseStrategy>("choose-strategy", line_field("id", &ChooseStrategy::id),
                              line_field("slowly", &ChooseStrategy::slowly)),
    line_kind<ChooseByNumber>("choose-by-number", line_field("id", &ChooseByNumber::id)),
    line_kind<TurnLandscapeDial>("turn-landscape-dial", line_field("cure", &TurnLandscapeDial::cure)),
    // Time
    line_kind<TogglePause>("toggle-pause"), line_kind<StepBack>("step-back"), line_kind<StepOn>("step-on"),
    line_kind<LookBackTo>("look-back-to", line_field("time", &LookBackTo::time_s)),
    line_kind<Restart>("restart", line_field("with-scene-settings", &Restart::with_scene_settings)),
    // Stage, lessons and the talk
    line_kind<ShowFace>("show-face", line_field("face", &ShowFace::face)), line_kind<SwitchFace>("switch-face"),
    line_kind<ToggleMode>("toggle-mode", line_field("mode", &ToggleMode::mode)), line_kind<MeasureHand>("measure-hand"),
    line_kind<PressMeasuringButton>("press-measuring-button"), line_kind<Confirm>("confirm"), line_kind<GoOn>("go-on"),
    line_kind<NextStep>("next-step"), line_kind<PreviousStep>("previous-step"), line_kind<ToggleBlank>("toggle-blank"),
    line_kind<ToggleMenu>("toggle-menu"), line_kind<ToggleNumbers>("toggle-numbers"),
    line_kind<AnswerLesson>("answer-lesson", line_field("answer", &AnswerLesson::answer)),
    line_kind<MoveSliderTo>("move-slider-to", line_field("value", &MoveSliderTo::value)),
    line_kind<NudgeSlider>("nudge-slider", line_field("hundredths", &NudgeSlider::hundredths)),
    line_kind<LeaveLesson>("leave-lesson"), line_kind<NextLanguage>("next-language"),
    // Motors
    line_kind<ArmMotors>("arm-motors"), line_kind<StopMotors>("stop-motors"),
    line_kind<AcknowledgeOff>("acknowledge-off"), line_kind<Escape>("escape"),
    // View and window
    line_kind<NextCompareMode>("next-compare-mode"),
    line_kind<ToggleViewOption>("toggle-view-option", line_field("option", &ToggleViewOption::option)),
    line_kind<FitView>("fit-view"),
    line_kind<ZoomView>("zoom-view", line_field("factor", &ZoomView::factor), line_field("place", &ZoomView::place)),
    line_kind<MoveView>("move-view", line_field("by", &MoveView::by)),
    line_kind<PanView>("pan-view", line_field("shares", &PanView::shares)), line_kind<TogglePlots>("toggle-plots"),
    line_kind<NextTheme>("next-theme"),
    line_kind<ChangeTextSize>("change-text-size", line_field("steps", &ChangeTextSize::steps)),
    line_kind<UseUsualTextSize>("use-usual-text-size"),
    line_kind<OpenDialog>("open-dialog", line_field("dialog", &OpenDialog::dialog)),
    line_kind<ToggleDialog>("toggle-dialog", line_field("dialog", &ToggleDialog::dialog)),
    line_kind<ChooseInput>("choose-input", line_field("name", &ChooseInput::name)),
    // Controls of panels and dialogs
    line_kind<HoldControl>("hold-control", line_field("is-held", &HoldControl::is_held)),
    line_kind<ChangeSpeed>("change-speed", line_field("speed", &ChangeSpeed::after)),
    line_kind<ChangeViewOptions>("change-view-options",
                                 line_field("compare", &ChangeViewOptions::after, &ViewOptions::compare),
                                 line_field("ghost-forces", &ChangeViewOptions::after, &ViewOptions::ghost_forces),
                                 line_field("predictions", &ChangeViewOptions::after, &ViewOptions::predictions),
                                 line_field("trails", &ChangeViewOptions::after, &ViewOptions::trails)),
    line_kind<ChangeAppearance>("change-appearance", line_field("theme", &ChangeAppearance::after, &Appearance::theme),
                                line_field("scale", &ChangeAppearance::after, &Appearance::scale),
                                line_field("arrows", &ChangeAppearance::after, &Appearance::arrow_scale)),
    line_kind<ChangeMotion>("change-motion", line_field("motion", &ChangeMotion::after)),
    line_kind<FollowSystemMotion>("follow-system-motion", line_field("is-reduced", &FollowSystemMotion::after)),
    line_kind<ChangePlots>("change-plots", line_field("is-open", &ChangePlots::after, &PlotView::is_open),
                           line_field("tab", &ChangePlots::after, &PlotView::tab),
                           line_field("follows", &ChangePlots::after, &PlotView::follows),
                           line_field("from", &ChangePlots::after, &PlotView::from_s),
                           line_field("to", &ChangePlots::after, &PlotView::to_s),
                           line_field("cursor", &ChangePlots::after, &PlotView::cursor_s)),
    line_kind<ChangeSafety>("change-safety",
                            line_field("needs-button", &ChangeSafety::after, &SafetyOptions::needs_button),
                            line_field("force-limit", &ChangeSafety::after, &SafetyOptions::force_limit),
                            line_field("greatest-k-r", &ChangeSafety::after, &SafetyOptions::greatest_k_r)),
    line_kind<ChangeSpaceMouse>("change-spacemouse",
                                line_field("mode", &ChangeSpaceMouse::after, &SpaceMouseSettings::mode),
                                line_field("up", &ChangeSpaceMouse::after, &SpaceMouseSettings::up),
                                line_field("dead-zone", &ChangeSpaceMouse::after, &SpaceMouseSettings::dead_zone),
                                line_field("reach", &ChangeSpaceMouse::after, &SpaceMouseSettings::reach_m),
                                line_field("speed", &ChangeSpaceMouse::after, &SpaceMouseSettings::speed_m_s)),
    line_kind<ChooseLanguage>("choose-language", line_field("language", &ChooseLanguage::after)),
    line_kind<SwitchSpeech>("switch-speech", line_field("speaks", &SwitchSpeech::after)),
    line_kind<InjectFault>("inject-fault", line_field("fault", &InjectFault::after)),
    line_kind<AimAtTarget>("aim-at-target", line_field("aims", &AimAtTarget::after)),
    line_kind<ChangeStiffnesses>(
        "change-stiffnesses", line_field("k-u", &ChangeStiffnesses::after, &Stiffnesses::k_u),
        line_field("believed-k-u", &ChangeStiffnesses::after, &Stiffnesses::believed_k_u),
        line_field("k-r", &ChangeStiffnesses::after, &Stiffnesses::k_r),
        line_field("k-t", &ChangeStiffnesses::after, &Stiffnesses::k_t),
        line_field("k-c", &ChangeStiffnesses::after, &Stiffnesses::k_c),
        line_field("tracking-ratio", &ChangeStiffnesses::after, &Stiffnesses::chosen_tracking_ratio)),
    line_kind<Believe>("believe", line_field("source", &Believe::source), line_field("k-u", &Believe::k_u)),
    line_kind<StartMeasuring>("start-measuring"), line_kind<TakeReading>("take-reading"),
    line_kind<CancelMeasuring>("cancel-measuring"), line_kind<RevealHand>("reveal-hand"),
    line_kind<BelieveMeasurement>("believe-measurement"), line_kind<BeginCircleTest>("begin-circle-test"),
    line_kind<EndCircleTest>("end-circle-test"),
    line_kind<ChangeCircle>("change-circle", line_field("radius", &ChangeCircle::after, &CircleChoice::radius),
                            line_field("is-clockwise", &ChangeCircle::after, &CircleChoice::is_clockwise)),
    line_kind<FollowNewest>("follow-newest"), line_kind<ForgetLessons>("forget-lessons"),
    line_kind<CloseDialog>("close-dialog"), line_kind<CloseNotice>("close-notice"), line_kind<HideHints>("hide-hints"),
    // What the shell does
    line_kind<Quit>("quit", line_field("ends-visit", &Quit::ends_visit)),
    line_kind<ToggleFullScreen>("toggle-full-screen"), line_kind<ToggleAudience>("toggle-audience"),
    line_kind<Undo>("undo"), line_kind<Redo>("redo"),
    line_kind<OpenScene>("open-scene", line_field("name", &OpenScene::name_or_path)),
    line_kind<OpenLesson>("open-lesson", line_field("name", &OpenLesson::name_or_path)),
    line_kind<DropFiles>("drop-files", line_field("paths", &DropFiles::paths)),
    line_kind<SaveScene>("save-scene", line_field("path", &SaveScene::path)),
    line_kind<SavePicture>("save-picture", line_field("path", &SavePicture::path),
                           line_field("density", &SavePicture::density),
                           line_field("scene-alone", &SavePicture::scene_alone)),
    line_kind<SaveClip>("save-clip", line_field("path", &SaveClip::path), line_field("seconds", &SaveClip::seconds),
                        line_field("end", &SaveClip::end_s),
                        line_field("frames-per-second", &SaveClip::frames_per_second)),
    line_kind<SavePlots>("save-plots", line_field("path", &SavePlots::path),
                         line_field("whole-history", &SavePlots::whole_history)),
    line_kind<CopyPicture>("copy-picture", line_field("density", &CopyPicture::density),
                           line_field("scene-alone", &CopyPicture::scene_alone)),
    line_kind<CopyValues>("copy-values"), line_kind<CopySetUp>("copy-set-up"),
    line_kind<PasteSetUp>("paste-set-up", line_field("line", &PasteSetUp::line)), line_kind<ShowLink>("show-link"),
    line_kind<ShowControls>("show-controls"),
    line_kind<StartRecording>("start-recording", line_field("path", &StartRecording::path)),
    line_kind<StopRecording>("stop-recording"), line_kind<ResetPreferences>("reset-preferences")};

static_assert(std::tuple_size_v<decltype(action_kinds)> == std::variant_size_v<AnyAction>);

}  // namespace ghostforce
