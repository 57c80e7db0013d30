# Compiles for arm64 on a Debian of another architecture, with the libraries of that architecture beside its own
# (dpkg --add-architecture arm64). What is run while building is the machine's own: Python, CMake. What has been built is
# run by qemu-user. .ci/arm64 makes such a Debian.

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)

set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(PKG_CONFIG_EXECUTABLE aarch64-linux-gnu-pkg-config)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)
