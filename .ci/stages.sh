# What .ci/run and .ci/nightly share; sourced by them. Stops at the first failure; the time of every
# stage is printed at the end.
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null
export CI=true
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}
if command -v ccache >/dev/null; then
  # Paths relative to this clone: another clone's objects serve as well.
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
fi

times=()
stage_name="start"

finish() {
  local code=$?
  printf '\n%s\n' "${times[@]}" "in all ${SECONDS} s"
  if ((code != 0)); then echo "CI FAILED in stage '$stage_name' (exit $code)"; fi
}
trap finish EXIT

# stage NAME COMMAND...
stage() {
  stage_name=$1
  local begin=$SECONDS
  printf '\n== %s\n' "$stage_name"
  "${@:2}"
  times+=("$(printf '%5d s  %s' $((SECONDS - begin)) "$stage_name")")
}

# configure PRESET [CMAKE ARGUMENT...]: warnings are errors.
configure() { cmake --preset "$1" -DLASIUS_WERROR=ON "${@:2}"; }

# Builds for sanitizers: what they report names functions, not lines, which take a tenth of the build. The
# presets alone have the lines.
no_lines() { case $1 in asan-ubsan | tsan | fuzz) echo -DCMAKE_CXX_FLAGS_DEBUG=-O1 ;; esac; }

target=  # of build_and_test; empty: all
# build_and_test PRESET [CTEST ARGUMENT...]
build_and_test() {
  configure "$1" $(no_lines "$1")
  cmake --build --preset "$1" ${target:+--target "$target"}
  ctest --preset "$1" "${@:2}"
}

# without_tests CASES PRESET [CTEST ARGUMENT...]: without these cases of GoogleTest, a:b*:c
without_tests() {
  local -x GTEST_FILTER="-$1"
  build_and_test "${@:2}"
}

# The public reference, where each warning is an error.
reference() {
  mkdir -p build
  doxygen docs/Doxyfile
}

# What is made from other files is up to date.
made_documents() {
  docs/draw_modules --check
  docs/quote_examples --check
}

# tidy CHECKS: core/ and kernels/, several modules at a time, as each looks through all headers; headers not precompiled. CHECKS are added to those of .clang-tidy.
tidy() {
  cmake --preset dev-clang -B build/tidy -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DLASIUS_UNITY=ON \
    -DLASIUS_SHORT_BUILD=ON
  sed -n 's/.*"file": "\(.*\)".*/\1/p' build/tidy/compile_commands.json |
    grep -E "^$PWD/(build/tidy/)?(core|kernels)/" | sort -u |
    xargs -n 1 -P "$(nproc)" clang-tidy --quiet --checks="$1,-bugprone-suspicious-include" -p build/tidy
}

# fuzz_one TARGET SECONDS
fuzz_one() {
  local name=${1##*/fuzz_} found=${1%/bin/*}/found streams=0
  [[ $name != command ]] || streams=3  # what commands print
  mkdir -p "$found/$name"
  tar -xzf "tests/fuzz/corpus/$name.tar.gz" -C "$found/$name"
  "$1" -max_total_time="$2" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 -verbosity=0 \
    -close_fd_mask="$streams" -artifact_prefix="$found/$name-" "$found/$name" "tests/fuzz/corpus/$name"
}

# fuzz SECONDS [CONFIGURE ARGUMENT...]: of processor time, for all targets together
fuzz() {
  cmake --preset fuzz $(no_lines fuzz) "${@:2}"
  rm -f build/asan-ubsan/bin/fuzz_*  # of other options
  cmake --build --preset fuzz
  local targets=(build/asan-ubsan/bin/fuzz_*)
  export -f fuzz_one
  printf '%s\0' "${targets[@]}" |
    xargs -0 -P "$(nproc)" -I{} bash -c 'fuzz_one "$@"' - {} $(($1 / ${#targets[@]}))
}
