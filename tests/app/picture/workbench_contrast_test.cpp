// The words of the workbench's scene can be read, in every theme: over pictures by dice.
#include <gtest/gtest.h>

#include "app/picture/text.h"
#include "tests/app/picture/word_contrast.h"
#include "tests/app/picture/workbench_case.h"

namespace ghostforce::workbench_contrast_test {
namespace {

TEST(WorkbenchContrast, EveryWordCanBeReadInEveryTheme) {
  PictureDice dice(20261127);
  int faulty = 0;
  for (int i = 0; i < 300; ++i) {
    WorkbenchCase shown = workbench_case_by(dice);
    for (const Theme& theme : theme_catalog()) {
      shown.theme_name = theme.name;
      for (const Pane& pane : shown.compose()) {
        for (const std::string& fault : unreadable_words(pane, theme, measure_vector_text, shown.text_scale())) {
          if (++faulty <= 20) ADD_FAILURE() << i << " " << shown.words() << ": " << fault;
        }
      }
    }
  }
  EXPECT_EQ(faulty, 0);
}

}  // namespace
}  // namespace ghostforce::workbench_contrast_test
