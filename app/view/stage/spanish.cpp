// The words of the stage in Spanish.
#include "app/view/stage/stage_language.h"

namespace ghostforce {

const StageLanguage spanish_stage{
    .code = "es",
    .name = "Español",
    .sentences =
        {
            .in_hand = "En tu mano: la meta se deduce, y la fuerza fantasma no se puede saber.",
            .aim_and_push = "Apunta a la diana y empuja el mango contra la pared.",
            .push = "Empuja el mango contra la pared.",
            .aimed_with_ghost = "Apuntas a la diana, y una fuerza fantasma te arrastra por la pared.",
            .aimed_without_ghost = "Apuntas a la diana, y no hay fuerza fantasma.",
            .drag_into_wall = "Mete la mano en la pared.",
            .in_front_of_wall = "El mango está delante de la pared: nada lo empuja.",
            .two_motors = "Dos motores: la pared se siente bien.",
            .one_becomes_two = "Un motor se convierte en dos.",
            .two_become_one = "Dos motores se convierten en uno.",
            .motor_along_wall = "El único motor empuja a lo largo de la pared: no puede sujetar la mano.",
            .on_way_to_cure = "De camino a la cura: aún hay fuerza fantasma.",
            .on_way_to_naive = "De vuelta a ingenuo: hay fuerza fantasma.",
            .on_way_without_ghost = "De camino entre los dos: sin fuerza fantasma.",
            .naive_ghost = "Una fuerza fantasma arrastra el mango por la pared.",
            .naive_too_little = "El motor empuja de menos mientras la mano se mueve.",
            .straight_at_wall = "Un motor, recto contra la pared: aquí no hay fuerza fantasma.",
            .press_deeper = "Aprieta más hondo: aquí apenas hay fuerza fantasma.",
            .cured = "El mismo motor, la misma mano: la fuerza fantasma se ha ido.",
            .hold_still = "Deja quieta la mano, y la fuerza fantasma se irá.",
            .stiffer_than_believed = "La mano es más rígida de lo supuesto: queda fuerza fantasma.",
            .softer_than_believed = "La mano es más blanda de lo supuesto: queda fuerza fantasma.",
            .wrong_ratio = "Esta relación no le va a la mano: queda fuerza fantasma.",
            .ghost_will_remain = "Deja quieta la mano: quedará una pequeña fuerza fantasma.",

            .guess_was_off = "Tu apuesta falló por {} mm.",
            .guess_is_tried = "La mano aprieta, despacio.",
            .guess_needs_wall = "Mete la mano en la pared, y luego apuesta.",
            .guess_with_two_motors = "Dos motores. ¿Dónde descansará el mango?",
            .guess_with_one_motor = "Un motor. ¿Dónde descansará el mango?",

            .why_two_motors = "Dos motores empujan recto hacia fuera, como una pared.",
            .why_nothing_given = "El motor empuja a lo largo de la pared: no puede dar nada del empuje.",
            .why_all_given = "Aquí el motor también empuja recto hacia fuera: sin fuerza fantasma.",
            .why_cured = "La cura: donde el motor no puede empujar, la pared cede.",
            .why_ghost = "Una pared empuja recto hacia fuera. Un solo motor no puede.",
            .why_needs_wall = "Primero mete la mano más hondo en la pared.",

            .round_begins = "Vueltas y vueltas: una pared de verdad no daría nada a la mano.",
            .round_leaves_wall = "El mango sale de la pared en su vuelta.",
            .round_gives = "En cada vuelta la pared da energía: empuja a la mano.",
            .round_gives_though_cured = "Sin fuerza fantasma en reposo, y aun así cada vuelta da energía.",
            .round_takes = "En cada vuelta la pared quita energía a la mano.",
            .round_is_fair = "Vueltas y vueltas, y apenas se gana o se pierde nada.",

            .drag_along_ribbon = "Arrastra por la cinta: otra vez el último minuto.",
        },
    .labels =
        {
            .ghost = "fantasma",
            .wall = "pared",
            .motor = "motor",
            .slid = "desliza",
            .handle = "mango",
            .target = "apunta aquí",
            .should_rest = "aquí debería parar",
            .should_hold = "aquí debería sujetar la pared",
            .virtual_wall = "pared virtual",
            .hand = "tu mano tira aquí",
            .hand_in_wall = "tu mano tira aquí, {} mm adentro",
            .hand_to_drag = "arrástrame: tu mano tira aquí",
            .hand_inferred = "tu mano, deducida",
            .motor_to_turn = "gira el motor por sus extremos",
            .motor_pushes = "el motor solo empuja {}",
            .left_and_right = "a izquierda y derecha",
            .up_and_down = "arriba y abajo",
            .at_angle = "a {}°",
            .guess = "tu apuesta",
            .guess_to_drag = "tu apuesta: arrástrame",
            .guess_off = "tu apuesta: falló por {} mm",
            .first_round = "la primera vuelta",
            .energy_a_round = "{} mJ por vuelta",
        },
    .numbers =
        {
            .ghost_force = "fuerza fantasma",
            .ghost_force_too_little = "fantasma (de menos)",
            .ghost_force_unknown = "fantasma: no se sabe",
            .slide = "deslizamiento",
            .slide_unknown = "desliza: no se sabe",
        },
    .strategies = std::to_array<StageLanguage::StrategyButton>({
        {.in_full = "Dos motores", .in_short = "Dos motores"},
        {.in_full = "Un motor, ingenuo", .in_short = "Ingenuo"},
        {.in_full = "Un motor, anisótropo", .in_short = "Anisótropo"},
    }),
    .modes =
        {
            .predict = {.title = "Predecir", .about = "adivina dónde descansará el mango."},
            .why = {.title = "¿Por qué?", .about = "de dónde viene la fuerza fantasma, en cuatro pasos."},
            .landscape = {.title = "Mapa", .about = "cuánta fuerza fantasma hay, para cada pared y cada mano."},
            .round = {.title = "Vueltas y vueltas",
                      .about = "cuánta energía da la pared a una mano que gira dentro de ella."},
            .ribbon = {.title = "Último minuto", .about = "mira otra vez lo que acaba de pasar."},
        },
    .hovers =
        {
            .lessons = "Lecciones ({}): sesiones cortas que preguntan, y luego muestran.",
            .workbench = "Banco de trabajo (F4): todos los ajustes, números y gráficas.",
            .leave_lesson = "Salir de la lección (Esc).",
            .wall = "Arrastra para girar la pared.",
            .motor = "Arrastra para girar el motor.",
        },
    .why =
        {
            .push = "1  la pared empuja recto:",
            .share = "2  de ese empuje, el motor puede dar:",
            .no_share_missing = "3  falta todo",
            .no_share_excess = "4  y no hay fuerza fantasma",
            .all_share_missing = "3  no falta nada",
            .all_share_excess = "4  así nada se desliza: sin fuerza fantasma",
            .cured_missing = "3  esto falta, y la pared cede",
            .cured_excess = "4  así nada se desliza: sin fuerza fantasma",
            .missing = "3  esto falta: se desliza",
            .hardly_any_excess = "4  apenas hay fuerza fantasma",
            .excess = "4  y el deslizamiento tira: fantasma",
        },
    .map =
        {
            .title = "¿Dónde va mal?",
            .stiffness_axis = "rigidez de pared : rigidez de mano",
            .angle_axis = "ángulo entre el empuje de la pared y el motor|"
                          "ángulo entre el empuje\nde la pared y el motor",
            .you_are_here = "estás aquí: {}",
            .off_the_map = "fuera del mapa: {}",
            .no_ghost = "aquí no hay fuerza fantasma",
            .too_much = "de más",
            .too_little = "de menos",
            .verdict = "del empuje de la pared, {},\ncon esta pared y esta mano|"
                       "del empuje de la pared,\n{}, con esta pared\ny esta mano",
            .sentence = "Con esta pared y esta mano: {} del empuje de la pared, {}.",
            .sentence_without_ghost = "Con esta pared y esta mano no hay fuerza fantasma.",
            .drag_ring = "Arrastra el anillo: pared y rigidez lo siguen.|"
                         "Arrastra el anillo:\npared y rigidez lo siguen.",
            .two_motors = "Dos motores: ninguna pared da fuerza fantasma.|"
                          "Dos motores: ninguna pared\nda fuerza fantasma.|"
                          "Dos motores:\nninguna pared\nda fuerza fantasma.",
            .naive = "ingenuo",
            .optimal = "óptimo",
            .chosen_ratio = "elegido",
            .slide_to_cure = "muéveme: el rojo se va|muéveme:\nel rojo se va",
            .slide_for_less = "muéveme: menos rojo",
        },
    .ribbon =
        {
            .now = "ahora",
            .milliseconds_ago = "hace {} ms",
            .seconds_ago = "hace {} s",
            .title = "fuerza fantasma, de 0 a {} N",
            .short_title = "de 0 a {} N",
            .title_unknown = "fuerza fantasma: no se puede saber",
        },
    .buttons =
        {
            .lessons = "{} lecciones",
            .keys = "{} teclas",
            .link = "{} enlace",
            .cure_hint = "pulsa 3: la cura",
            .show_guess = "Intro: muéstramelo",
            .skip = "Intro: saltar",
            .guess_again = "Intro: otra apuesta",
            .next_step = "Intro: siguiente paso",
            .back = "Esc: volver",
        },
    .warnings =
        {
            // The workbench speaks English.
            .unstable = "Con estos ajustes la simulación es inestable. Pulsa F4 y baja «rendering stiffness».",
            .unstable_on_workbench = "Con estos ajustes la simulación es inestable. Baja «rendering stiffness».",
            .device_not_ready = "El dispositivo no está listo: {} dice qué hacer.",
            .device_not_ready_for_visitors = "El dispositivo no está listo. Pide ayuda, por favor.",
            .paused = "En pausa. Pulsa la barra espaciadora para seguir.",
        },
    .motors =
        {
            .none = "sin motor",
            .off_by_key = "Motores parados. Aceptar",
            .off = "Motores parados: {}. Aceptar",
            .arm = "Activar los motores",
            .not_ready = "Motores no preparados",
            .arming = "Activando… Esc: parar",
            .on = "EN MARCHA. Esc: parar",
            .fading = "Parando MOTORES",
            .reasons =
                {
                    "parados",
                    "los has parado",
                    "no hay nadie",
                    "botón suelto",
                    "ventana detrás de otra",
                    "demasiado rápido",
                    "demasiada fuerza",
                    "respuesta tardía",
                    "ventana parada",
                    "desconectado",
                    "sin punto de referencia",
                    "el programa se cierra",
                    "fallo",
                },
        },
    .lessons =
        {
            .place = "{} de {}",
            .back = "Atrás",
            .next = "Siguiente",
            .show = "Muéstramelo",
            .answer = "Esa es mi apuesta",
            .not_quite = "No del todo. {}",
            .finish = "Terminar",
            .k_u = "rigidez de la mano",
            .believed_k_u = "rigidez que suponemos en la mano",
            .k_r = "rigidez de la pared",
            .tracking_ratio = "de ingenuo a la cura",
            .wall_angle = "ángulo de la pared",
            .motor_angle = "ángulo del motor",
        },
    .picker =
        {
            .title = "Lecciones",
            .steps = "{} pasos",
            .step = "Paso {} de {}",
            .done = "Hecha",
            .right = "{} de {} aciertos",
            .about =
                "Cada una pregunta qué va a pasar antes de mostrarlo. Intro o un clic la empiezan; Esc la termina.",
            .forget = "Olvidar mi progreso…",
            .forget_question = "¿Olvidar hasta dónde has llegado en todas las lecciones?",
            .forget_yes = "Olvidarlo",
            .forget_no = "Conservarlo",
            .open_file = "Abrir un archivo…",
            .close = "Cerrar",
        },
    .notices =
        {
            .copied_set_up = "Esta escena se ha copiado como orden. Ctrl+V la muestra otra vez; también al ejecutarla "
                             "en una terminal.",
            .pasted_set_up = "Esta es la escena pegada. Ctrl+Z la deshace.",
            .picture_shown = "Esto es lo que muestra {}. Ctrl+Z lo deshace.",
            .copied_picture = "Imagen copiada. Se puede pegar en otros programas.",
            .saved = "Guardado: {}",
            .saving = "Guardando {}: {} %. Cierra esto, o pulsa Esc, para cancelar.",
            .not_saved = "{} no se ha guardado.",
            .problem = "Atención",
            .close = "Cerrar",
        },
};

}  // namespace ghostforce
