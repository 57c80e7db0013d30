// Messages between this page and the one around it, which is of the origin that the address names (docs/web.md).
function exchangeMessages(origin) {
  const version = 1;
  const program = window.ghostforce;
  const tell = (tells, values) => parent.postMessage({ ghostforce: version, tells, ...values }, origin);
  const done = (why) => (why ? { done: false, why } : { done: true });
  // What a notice quotes, such as a text that was pasted, is the person's business alone.
  const state = () => {
    const { notice, ...told } = program.state();
    return told;
  };
  const answers = {
    state: () => ({ done: true, state: state() }),
    actions: () => ({ done: true, actions: program.actions() }),
    show: (message) => done(program.show(String(message.set_up))),
    lesson: (message) => done(program.begin_lesson(String(message.name))),
    act: (message) => done(program.act(String(message.action))),
  };
  // Whatever becomes of it, who asks has an answer.
  const answerTo = (ask, data) => {
    try {
      return answers[ask](data);
    } catch (error) {
      return done(error?.message || "The program has failed: " + error);
    }
  };
  addEventListener("message", ({ source, origin: sender, data }) => {
    if (source !== parent || sender !== origin || !data?.ghostforce) return;
    const { ask, id } = data;
    if (data.ghostforce !== version) {
      tell("answer", { id, ...done("This page speaks version " + version + ".") });
    } else if (!Object.hasOwn(answers, ask)) {
      tell("answer", { id, ...done("Ask for one of " + Object.keys(answers).join(", ") + ".") });
    } else {
      tell("answer", { id, ...answerTo(ask, data) });
    }
  });
  Module.tellLesson = (lesson) => tell("lesson", { lesson });
  Module.tellAction = (action) => tell("action", { action });

  const whole = (numbers, digits) => numbers.map((each) => Number(each.toFixed(digits)));
  let before = "";  // at the last look
  let told = "";
  const look = () => {
    const { set_up, face, mode, strategy, goal_m, device_m, proxy_m, force_N, ghost_force_N } = program.state();
    const values = {
      set_up, face, mode, strategy,
      goal_m: whole(goal_m, 6), device_m: whole(device_m, 6), proxy_m: whole(proxy_m, 6),
      force_N: whole(force_N, 3), ghost_force_N: whole(ghost_force_N, 3),
    };
    const now = JSON.stringify(values);
    if (now === before && now !== told) {
      told = now;
      tell("values", { values });
    }
    before = now;
  };
  tell("ready", { state: state() });
  setInterval(look, 250);
}
