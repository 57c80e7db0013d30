// Gallery: the pictures of cases, each drawn when it is asked for, and kept only where another case will ask for it
// again. Main thread only (OpenGL offscreen).
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/check/case_file.h"
#include "app/picture.h"

namespace ghostforce {

struct DrawnCase {
  Image image;
  GoldenOrigin origin;
};

class Gallery {
 public:
  // Plays every scene that will be needed: the chosen cases' and those they are compared with. Throws Failure:
  // wrong_call with all the scenes that cannot be drawn, a line each; interrupted. `all` must outlive the gallery.
  Gallery(const std::vector<Case>& all, const std::vector<const Case*>& chosen);

  // `name` is one of the chosen, or one that such a case is compared with. Throws Failure: no_display, interrupted.
  DrawnCase draw(const std::string& name);

 private:
  struct Prepared {
    const Case* described = nullptr;
    Moment moment;
  };

  std::map<std::string, Prepared, std::less<>> prepared_;
  std::set<std::string, std::less<>> wanted_again_;
  std::map<std::string, DrawnCase, std::less<>> kept_;
};

}  // namespace ghostforce
