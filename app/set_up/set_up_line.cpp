#include "app/set_up/set_up_line.h"
