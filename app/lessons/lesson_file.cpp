#include "app/lessons/lesson_file.h"
