#include "app/lessons/lesson_file.h"

#include <gtest/gtest.h>
