#include "app/shell/action_text.h"

#include <array>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "app/files/toml_document.h"

namespace ghostforce {
namespace {

template <typename Kind>
struct ActionRow : ActionKind {};

template <typename Kind>
constexpr ActionRow<Kind> action_kind(std::string_view name, auto... fields) {
  return {{line_kind<Kind>(name, fields...), [] { return Action(Kind{}); }}};
}

// In the order of AnyAction.
template <typename... Kinds>
constexpr std::array<ActionKind, sizeof...(Kinds)> table_of(const ActionRow<Kinds>&... rows) {
  static_assert(std::is_same_v<std::variant<Kinds...>, AnyAction>,
                "an Action has no row, or not where it has its place");
  return {rows...};
}

constexpr std::array action_rows = table_of(
    // Hand, motor and wall
    action_kind<MoveHandBy>("move-hand-by", line_field<&MoveHandBy::by>("by")),
    action_kind<MoveHandTo>("move-hand-to", line_field<&MoveHandTo::goal>("goal")),
    action_kind<LetGoOfHand>("let-go-of-hand"),
    action_kind<MoveGuessTo>("move-guess-to", line_field<&MoveGuessTo::guess>("guess")),
    action_kind<TurnMotorTo>("turn-motor-to", line_field<&TurnMotorTo::angle>("angle")),
    action_kind<TurnWallTo>("turn-wall-to", line_field<&TurnWallTo::angle>("angle")),
    action_kind<GoToLandscapePoint>("go-to-landscape-point",
                                    line_field<&GoToLandscapePoint::point, &LandscapePoint::angle>("angle"),
                                    line_field<&GoToLandscapePoint::point, &LandscapePoint::kappa>("kappa")),
    action_kind<TurnMotorBy>("turn-motor-by", line_field<&TurnMotorBy::degrees>("degrees")),
    action_kind<TurnWallToLargestDrift>("turn-wall-to-largest-drift"),
    action_kind<MovePart>("move-part", line_field<&MovePart::part>("part"), line_field<&MovePart::to>("to")),
    action_kind<SwitchMotor>("switch-motor"),
    action_kind<UseMotors>("use-motors", line_field<&UseMotors::motors>("motors")),
    action_kind<TurnRatio>("turn-ratio", line_field<&TurnRatio::factor>("factor")),
    // Strategies
    action_kind<ChooseStrategy>("choose-strategy", line_field<&ChooseStrategy::id>("id"),
                                line_field<&ChooseStrategy::slowly>("slowly")),
    action_kind<ChooseByNumber>("choose-by-number", line_field<&ChooseByNumber::id>("id")),
    action_kind<TurnLandscapeDial>("turn-landscape-dial", line_field<&TurnLandscapeDial::cure>("cure")),
    // Time
    action_kind<TogglePause>("toggle-pause"), action_kind<StepBack>("step-back"), action_kind<StepOn>("step-on"),
    action_kind<LookBackTo>("look-back-to", line_field<&LookBackTo::time_s>("time")),
    action_kind<Restart>("restart", line_field<&Restart::with_scene_settings>("with-scene-settings")),
    // Stage, lessons and the talk
    action_kind<ShowFace>("show-face", line_field<&ShowFace::face>("face")), action_kind<SwitchFace>("switch-face"),
    action_kind<ToggleMode>("toggle-mode", line_field<&ToggleMode::mode>("mode")),
    action_kind<MeasureHand>("measure-hand"), action_kind<PressMeasuringButton>("press-measuring-button"),
    action_kind<Confirm>("confirm"), action_kind<GoOn>("go-on"), action_kind<NextStep>("next-step"),
    action_kind<PreviousStep>("previous-step"), action_kind<ToggleBlank>("toggle-blank"),
    action_kind<ToggleMenu>("toggle-menu"), action_kind<ToggleNumbers>("toggle-numbers"),
    action_kind<AnswerLesson>("answer-lesson", line_field<&AnswerLesson::answer>("answer")),
    action_kind<MoveSliderTo>("move-slider-to", line_field<&MoveSliderTo::value>("value")),
    action_kind<NudgeSlider>("nudge-slider", line_field<&NudgeSlider::hundredths>("hundredths")),
    action_kind<LeaveLesson>("leave-lesson"), action_kind<NextLanguage>("next-language"),
    // Motors
    action_kind<ArmMotors>("arm-motors"), action_kind<ConfirmZeroPose>("confirm-zero-pose"),
    action_kind<StopMotors>("stop-motors"), action_kind<AcknowledgeOff>("acknowledge-off"),
    action_kind<Escape>("escape"),
    // View and window
    action_kind<NextCompareMode>("next-compare-mode"),
    action_kind<ToggleViewOption>("toggle-view-option", line_field<&ToggleViewOption::option>("option")),
    action_kind<FitView>("fit-view"),
    action_kind<ZoomView>("zoom-view", line_field<&ZoomView::factor>("factor"), line_field<&ZoomView::place>("place")),
    action_kind<MoveView>("move-view", line_field<&MoveView::by>("by")),
    action_kind<PanView>("pan-view", line_field<&PanView::shares>("shares")), action_kind<TogglePlots>("toggle-plots"),
    action_kind<NextTheme>("next-theme"),
    action_kind<ChangeTextSize>("change-text-size", line_field<&ChangeTextSize::steps>("steps")),
    action_kind<UseUsualTextSize>("use-usual-text-size"),
    action_kind<OpenDialog>("open-dialog", line_field<&OpenDialog::dialog>("dialog")),
    action_kind<ToggleDialog>("toggle-dialog", line_field<&ToggleDialog::dialog>("dialog")),
    action_kind<ChooseInput>("choose-input", line_field<&ChooseInput::name>("name")),
    // Controls of panels and dialogs
    action_kind<HoldControl>("hold-control", line_field<&HoldControl::is_held>("is-held")),
    action_kind<ChangeSpeed>("change-speed", line_field<&ChangeSpeed::after>("speed")),
    action_kind<ChangeViewOptions>("change-view-options",
                                   line_field<&ChangeViewOptions::after, &ViewOptions::compare>("compare"),
                                   line_field<&ChangeViewOptions::after, &ViewOptions::ghost_forces>("ghost-forces"),
                                   line_field<&ChangeViewOptions::after, &ViewOptions::predictions>("predictions"),
                                   line_field<&ChangeViewOptions::after, &ViewOptions::trails>("trails")),
    action_kind<ChangeAppearance>("change-appearance",
                                  line_field<&ChangeAppearance::after, &Appearance::theme>("theme"),
                                  line_field<&ChangeAppearance::after, &Appearance::scale>("scale"),
                                  line_field<&ChangeAppearance::after, &Appearance::arrow_scale>("arrows")),
    action_kind<ChangeMotion>("change-motion", line_field<&ChangeMotion::after>("motion")),
    action_kind<FollowSystemMotion>("follow-system-motion", line_field<&FollowSystemMotion::after>("is-reduced")),
    action_kind<ChangePlots>("change-plots", line_field<&ChangePlots::after, &PlotView::is_open>("is-open"),
                             line_field<&ChangePlots::after, &PlotView::tab>("tab"),
                             line_field<&ChangePlots::after, &PlotView::follows>("follows"),
                             line_field<&ChangePlots::after, &PlotView::from_s>("from"),
                             line_field<&ChangePlots::after, &PlotView::to_s>("to"),
                             line_field<&ChangePlots::after, &PlotView::cursor_s>("cursor")),
    action_kind<ChangeSafety>("change-safety",
                              line_field<&ChangeSafety::after, &SafetyOptions::needs_button>("needs-button"),
                              line_field<&ChangeSafety::after, &SafetyOptions::force_limit>("force-limit"),
                              line_field<&ChangeSafety::after, &SafetyOptions::greatest_k_r>("greatest-k-r")),
    action_kind<ChangeSpaceMouse>("change-spacemouse",
                                  line_field<&ChangeSpaceMouse::after, &SpaceMouseSettings::mode>("mode"),
                                  line_field<&ChangeSpaceMouse::after, &SpaceMouseSettings::up>("up"),
                                  line_field<&ChangeSpaceMouse::after, &SpaceMouseSettings::dead_zone>("dead-zone"),
                                  line_field<&ChangeSpaceMouse::after, &SpaceMouseSettings::reach_m>("reach"),
                                  line_field<&ChangeSpaceMouse::after, &SpaceMouseSettings::speed_m_s>("speed")),
    action_kind<ChooseLanguage>("choose-language", line_field<&ChooseLanguage::after>("language")),
    action_kind<SwitchSpeech>("switch-speech", line_field<&SwitchSpeech::after>("speaks")),
    action_kind<InjectFault>("inject-fault", line_field<&InjectFault::after>("fault")),
    action_kind<AimAtTarget>("aim-at-target", line_field<&AimAtTarget::after>("aims")),
    action_kind<ChangeStiffnesses>(
        "change-stiffnesses", line_field<&ChangeStiffnesses::after, &Stiffnesses::k_u>("k-u"),
        line_field<&ChangeStiffnesses::after, &Stiffnesses::believed_k_u>("believed-k-u"),
        line_field<&ChangeStiffnesses::after, &Stiffnesses::k_r>("k-r"),
        line_field<&ChangeStiffnesses::after, &Stiffnesses::k_t>("k-t"),
        line_field<&ChangeStiffnesses::after, &Stiffnesses::k_c>("k-c"),
        line_field<&ChangeStiffnesses::after, &Stiffnesses::chosen_tracking_ratio>("tracking-ratio")),
    action_kind<Believe>("believe", line_field<&Believe::source>("source"), line_field<&Believe::k_u>("k-u")),
    action_kind<StartMeasuring>("start-measuring"), action_kind<TakeReading>("take-reading"),
    action_kind<CancelMeasuring>("cancel-measuring"), action_kind<RevealHand>("reveal-hand"),
    action_kind<BelieveMeasurement>("believe-measurement"), action_kind<BeginCircleTest>("begin-circle-test"),
    action_kind<EndCircleTest>("end-circle-test"),
    action_kind<ChangeCircle>("change-circle", line_field<&ChangeCircle::after, &CircleChoice::radius>("radius"),
                              line_field<&ChangeCircle::after, &CircleChoice::is_clockwise>("is-clockwise")),
    action_kind<FollowNewest>("follow-newest"), action_kind<ForgetLessons>("forget-lessons"),
    action_kind<CloseDialog>("close-dialog"), action_kind<CloseNotice>("close-notice"),
    action_kind<HideHints>("hide-hints"),
    // What the shell does
    action_kind<Quit>("quit", line_field<&Quit::ends_visit>("ends-visit")),
    action_kind<ToggleFullScreen>("toggle-full-screen"), action_kind<ToggleAudience>("toggle-audience"),
    action_kind<Undo>("undo"), action_kind<Redo>("redo"),
    action_kind<OpenScene>("open-scene", line_field<&OpenScene::name_or_path>("name")),
    action_kind<OpenLesson>("open-lesson", line_field<&OpenLesson::name_or_path>("name")),
    action_kind<DropFiles>("drop-files", line_field<&DropFiles::paths>("paths")),
    action_kind<SaveScene>("save-scene", line_field<&SaveScene::path>("path")),
    action_kind<SavePicture>("save-picture", line_field<&SavePicture::path>("path"),
                             line_field<&SavePicture::density>("density"),
                             line_field<&SavePicture::scene_alone>("scene-alone")),
    action_kind<SaveClip>("save-clip", line_field<&SaveClip::path>("path"), line_field<&SaveClip::seconds>("seconds"),
                          line_field<&SaveClip::end_s>("end"),
                          line_field<&SaveClip::frames_per_second>("frames-per-second")),
    action_kind<SavePlots>("save-plots", line_field<&SavePlots::path>("path"),
                           line_field<&SavePlots::whole_history>("whole-history")),
    action_kind<CopyPicture>("copy-picture", line_field<&CopyPicture::density>("density"),
                             line_field<&CopyPicture::scene_alone>("scene-alone")),
    action_kind<CopyValues>("copy-values"), action_kind<CopySetUp>("copy-set-up"),
    action_kind<PasteSetUp>("paste-set-up", line_field<&PasteSetUp::line>("line")), action_kind<ShowLink>("show-link"),
    action_kind<ShowControls>("show-controls"),
    action_kind<StartRecording>("start-recording", line_field<&StartRecording::path>("path")),
    action_kind<StopRecording>("stop-recording"), action_kind<ResetPreferences>("reset-preferences"));

}  // namespace

std::span<const ActionKind> action_kinds() noexcept {
  return action_rows;
}

const void* object_of(const Action& action) {
  return std::visit([](const auto& one) -> const void* { return &one; }, action);
}

void* object_of(Action& action) {
  return const_cast<void*>(object_of(std::as_const(action)));
}

std::string line_value(std::string_view text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-._,:/";
  return !text.empty() && text.find_first_not_of(plain) == std::string_view::npos ? std::string(text)
                                                                                  : toml_string(text);
}

std::string kind_text(const LineKind& kind, const void* object) {
  std::string text(kind.name);
  for (const LineField& field : kind.fields())
    text += fmt::format(" {}={}", field.name, line_value(field.text(object)));
  return text;
}

std::string action_text(const Action& action) {
  return kind_text(action_rows[action.index()].line, object_of(action));
}

}  // namespace ghostforce
