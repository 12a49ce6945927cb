#!/bin/sh
# Installs the libraries into a scratch directory and builds another program against them with find_package(crevice).
# usage: install_test.sh BUILD_DIRECTORY CXX_COMPILER
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$1" --prefix "$scratch/installed" >/dev/null
mkdir "$scratch/user"
cat > "$scratch/user/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(user LANGUAGES CXX)
find_package(crevice 0.1 REQUIRED)
add_executable(user user.cpp)
target_link_libraries(user PRIVATE crevice::ssao crevice::scenes)
CMAKE
cat > "$scratch/user/user.cpp" <<'CPP'
#include <cstdio>

#include <scenes/builtin_scenes.h>
#include <ssao/methods/luna_ssao.h>

int main() {
    const crevice::Scene scene = crevice::find_builtin_scene("wall_corner")->make();
    const crevice::GBuffer gbuffer = crevice::normal_depth(scene, scene.camera, {64, 36});
    const crevice::Image<float> ao = crevice::luna_ssao(gbuffer, scene.camera).ao;
    float darkest = 1;
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) darkest = ao.at(x, y) < darkest ? ao.at(x, y) : darkest;
    }
    std::printf("darkest %g\n", static_cast<double>(darkest));
    return darkest < 1 ? 0 : 1;
}
CPP
flags=$(sed -n 's/^CREVICE_SANITIZE:STRING=//p' "$1/CMakeCache.txt")
cmake -G Ninja -S "$scratch/user" -B "$scratch/build" -DCMAKE_PREFIX_PATH="$scratch/installed" -DCMAKE_CXX_COMPILER="$2" \
    ${flags:+-DCMAKE_CXX_FLAGS=-fsanitize=$flags} >/dev/null
cmake --build "$scratch/build" >/dev/null
"$scratch/build/user"
