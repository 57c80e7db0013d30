// Only in builds for the leak sanitizer, which looks at the process when it ends: a library that was closed by then has
// lost its name, so that tests/support/lsan.supp cannot match what it left behind. Here no library is ever closed: this
// dlclose stands before the C library's, for our own calls and for those that OpenGL's libraries make among themselves.

const int ghostforce_keeps_libraries_loaded = 1;  // options.cmake asks the linker for this name

int dlclose(void* library);

int dlclose(void* library) {
  (void)library;
  return 0;
}
