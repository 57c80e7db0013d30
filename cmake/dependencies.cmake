# Everything that comes from outside, found in this one file: what it is, why we use it, how it gets here.
# "apt" means a Debian package listed in packages.txt, which ./demo and ./check install.
#
# Which folder may use which library is said in rooms.txt.
#
# The page in a browser is built in a Debian 13 of its own (cmake/page_toolchain.sh, the packages of [page]), because
# Debian 12's Emscripten is too old for C++20. It has the headers of glm, fmt, toml++ and nlohmann-json from there, and
# compiles what else it needs from pinned sources: page_sources.cmake.

# ---- The model -------------------------------------------------------------------------------------------------------

# glm: vectors and matrices of 2 to 4 dimensions, the only library that core/ may see. apt: libglm-dev.
if(NOT EMSCRIPTEN)
  find_package(glm CONFIG REQUIRED)
endif()

# ---- The desktop's devices -------------------------------------------------------------------------------------------

if(NOT EMSCRIPTEN)
  # Threads: the servo's. Part of the C library.
  set(THREADS_PREFER_PTHREAD_FLAG ON)
  find_package(Threads REQUIRED)

  find_package(PkgConfig REQUIRED)

  # libusb: transfers to and from the Falcon. apt: libusb-1.0-0-dev.
  pkg_check_modules(LIBUSB REQUIRED IMPORTED_TARGET libusb-1.0>=1.0.24)
  add_library(ghostforce::libusb ALIAS PkgConfig::LIBUSB)

  # hidapi: reports of a SpaceMouse, through the kernel's hidraw. apt: libhidapi-dev.
  pkg_check_modules(HIDAPI REQUIRED IMPORTED_TARGET hidapi-hidraw)
  add_library(ghostforce::hidapi ALIAS PkgConfig::HIDAPI)

  # libcrypto: the SHA-256 by which people compare their firmware file with others. apt: libssl-dev.
  find_package(OpenSSL REQUIRED COMPONENTS Crypto)
endif()

# ---- Files and words -------------------------------------------------------------------------------------------------

# Python: reads assets/languages while the program is built (languages.py), and runs glad. Debian's is named by its full
# path because one that stands earlier in PATH does not see Debian's modules. apt: python3, which python3-glad brings along.
find_program(GHOSTFORCE_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)

if(NOT EMSCRIPTEN)
  # fmt: text from numbers; g++ 12 has no <format>. apt: libfmt-dev.
  find_package(fmt REQUIRED)

  # toml++: scene files, with the line and column that an error message needs. apt: libtomlplusplus-dev.
  find_package(tomlplusplus REQUIRED)

  # nlohmann-json: JSON output. Headers only. apt: nlohmann-json3-dev.
  find_package(nlohmann_json REQUIRED)
endif()

# ---- The window, and pictures: found for the desktop, compiled for the page -----------------------------------------

if(EMSCRIPTEN)
  # Dear ImGui and ImPlot: ./web fetches their sources, which must be exactly this file.
  set(imgui_bundle_version 1.92.801)  # imgui-sources-requirements.txt
  set(imgui_bundle_sha256 7d790708affe7476969d397784b40eb91760a201ce752131e5bedf4d514e3a45)
  include(page_sources)

  # stb: makes PNG files smaller, in place of zlib and libpng. A header. apt: libstb-dev.

  # axe-core: looks for barriers in the page, in its tests alone. axe.sh fetches it.

  # QR codes, of the page's own address: qrcode-generator, JavaScript. apt: node-qrcode-generator.
  set(GHOSTFORCE_QR_CODE_SCRIPT /usr/share/nodejs/qrcode-generator/qrcode.js)
else()
  # CLI11: the command line. Headers only. apt: libcli11-dev.
  find_package(CLI11 REQUIRED)

  # libpng: reads PNG files whoever wrote them, checksums and all, and writes them. Cairo brings it along anyway.
  # apt: libpng-dev.
  find_package(PNG REQUIRED)

  # zlib: compresses the pictures of an animated PNG, which libpng does not write. libpng brings it along anyway.
  # apt: zlib1g-dev.
  find_package(ZLIB REQUIRED)

  # Cairo: SVG and PDF files. Its way from a font file to letters leads through FreeType, so that the machine's own
  # choice of fonts (fontconfig) has no say in a picture. apt: libcairo2-dev, libfreetype-dev.
  find_package(Freetype REQUIRED)
  find_path(CAIRO_INCLUDE_DIR cairo-ft.h PATH_SUFFIXES cairo REQUIRED)
  find_library(CAIRO_LIBRARY cairo REQUIRED)
  add_library(ghostforce::cairo INTERFACE IMPORTED)
  target_include_directories(ghostforce::cairo INTERFACE ${CAIRO_INCLUDE_DIR})
  target_link_libraries(ghostforce::cairo INTERFACE ${CAIRO_LIBRARY} Freetype::Freetype)

  # glad: the OpenGL 3.3 core loader, <glad/gl.h>, and the types of EGL, <glad/egl.h>, generated at build time. With the
  # extensions by which EGL tells devices apart, and by which Mesa draws into memory to the bit as into a window.
  # --reproducible makes it read the specification that it was installed with; without that it asks the network.
  # apt: python3-glad.
  set(glad_dir ${PROJECT_BINARY_DIR}/generated/glad)
  add_custom_command(
    OUTPUT ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h ${glad_dir}/include/glad/egl.h
    COMMAND ${GHOSTFORCE_PYTHON} -m glad --quiet --reproducible --api gl:core=3.3,egl=1.5
      --extensions=EGL_EXT_device_enumeration,EGL_EXT_device_query,EGL_EXT_platform_device,EGL_KHR_no_config_context,GL_MESA_framebuffer_flip_y
      --out-path ${glad_dir} c
    COMMENT "Generating the OpenGL 3.3 core loader and the types of EGL"
    VERBATIM)
  add_library(glad STATIC ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h ${glad_dir}/include/glad/egl.h)
  target_include_directories(glad SYSTEM PUBLIC ${glad_dir}/include)
  add_library(ghostforce::glad ALIAS glad)

  # Dear ImGui 1.92, ImPlot and GLFW 3.4: the window, the panels and the plots; one target, ghostforce::gui. Debian 12
  # has older ones or none. Packages with a CMake configuration (vcpkg, Conan) are taken where all three are there,
  # ImGui with its GLFW and OpenGL 3 backends; else prebuilt static libraries come from a pinned wheel.
  find_package(imgui CONFIG QUIET)
  find_package(implot CONFIG QUIET)
  find_package(glfw3 3.4 CONFIG QUIET)
  add_library(ghostforce::gui INTERFACE IMPORTED)
  if(imgui_FOUND AND implot_FOUND AND glfw3_FOUND)
    target_link_libraries(ghostforce::gui INTERFACE implot::implot imgui::imgui glfw)
  else()
    include(imgui_wheel)
    fetch_imgui_wheel(imgui_wheel_dir)
    target_include_directories(ghostforce::gui INTERFACE ${imgui_wheel_dir}/include)
    # In this order: ImGui's backend calls GLFW, GLFW opens X11, Wayland and OpenGL at run time.
    target_link_libraries(ghostforce::gui INTERFACE
      ${imgui_wheel_dir}/lib/libimgui.a ${imgui_wheel_dir}/lib/libglfw3.a Threads::Threads ${CMAKE_DL_LIBS} m)
  endif()
  # glad declares OpenGL; the system's <GL/gl.h> must stay out of its way.
  target_compile_definitions(ghostforce::gui INTERFACE GLFW_INCLUDE_NONE)

  # xcb: a connection to an X server beside GLFW's, which tells what becomes of the window without ending the program, as
  # Xlib does. Cairo brings it along anyway. apt: libxcb1-dev.
  pkg_check_modules(XCB REQUIRED IMPORTED_TARGET xcb)
  add_library(ghostforce::xcb ALIAS PkgConfig::XCB)

  # libsystemd: sd-bus, by which logind is asked to wait before the computer sleeps. Its header only: the library is
  # opened at run time, because a system without logind may lack it. apt: libsystemd-dev.
  find_path(SYSTEMD_INCLUDE_DIR systemd/sd-bus.h REQUIRED)
  add_library(ghostforce::libsystemd INTERFACE IMPORTED)
  target_include_directories(ghostforce::libsystemd INTERFACE ${SYSTEMD_INCLUDE_DIR})

  # EGL with Mesa's drivers, or OSMesa, which newer versions of Mesa lack: OpenGL in software into memory, for pictures
  # without a display. Opened at run time, the one by us and the other by GLFW: nothing to find here. apt: libegl1 and
  # libgl1-mesa-dri, libosmesa6.
endif()

# DejaVu: the font of the screen; ImGui's built-in one lacks ρ and κ. Debian splits it from no other font.
# apt: fonts-dejavu-core.
set(GHOSTFORCE_FONTS "")
foreach(font IN ITEMS DejaVuSans DejaVuSans-Bold DejaVuSansMono)
  find_file(GHOSTFORCE_FONT_${font} ${font}.ttf
    PATHS /usr/share/fonts/truetype/dejavu /usr/share/fonts/dejavu-sans-fonts /usr/share/fonts/TTF
    NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  list(APPEND GHOSTFORCE_FONTS ${GHOSTFORCE_FONT_${font}})
endforeach()

# ---- The tests -------------------------------------------------------------------------------------------------------

if(BUILD_TESTING)
  # GoogleTest. apt: libgtest-dev.
  find_package(GTest REQUIRED)

  # libsystemd once more, linked: the tests are the other end of a bus.
  pkg_check_modules(SYSTEMD REQUIRED IMPORTED_TARGET libsystemd)

  # umockdev: real libusb and real hidapi against devices that exist only at the kernel's boundary. A program,
  # umockdev-wrapper, and a library. apt: umockdev, libumockdev-dev.
  pkg_check_modules(UMOCKDEV REQUIRED IMPORTED_TARGET umockdev-1.0)
  find_program(UMOCKDEV_WRAPPER umockdev-wrapper REQUIRED)

  # Eigen: solves the equilibrium a second time, independently of core/. Headers only. apt: libeigen3-dev.
  find_package(Eigen3 REQUIRED)
endif()

# ---- The benchmarks --------------------------------------------------------------------------------------------------

if(GHOSTFORCE_BENCH)
  # Google Benchmark: repeats, times and takes medians. apt: libbenchmark-dev.
  find_package(benchmark REQUIRED)
endif()
