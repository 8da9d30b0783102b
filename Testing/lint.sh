#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Checks layout, spelling and common faults of all sources, and installs what it needs for that.
#
# usage: Testing/lint.sh [CHECK...]
#
# Checks: format, columns, spelling, python, shell, documents, texts, site, tidy, analyze; all by default. The last two
# are clang-tidy's, without and with its analyzer. They look at the real-time core only, and take a minute on two cores.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case ${1:-} in
  -h | --help) sed -n '5,10s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac
cd "$root"
# shellcheck source=../CMake/install-packages.sh
source CMake/install-packages.sh

# These tools find different faults from version to version, so all of them have the versions of Debian 12, except ruff,
# which Debian 12 lacks. lint-tools.txt has the versions, and the hashes that pip checks.

# Prints the files with one of the given endings, separated by null bytes.
list_files()
{
  local ending names=()
  for ending in "$@"; do
    names+=(-o -name "*$ending")
  done
  find Module Plugin Examples Testing CMake Data -type f \( "${names[@]:1}" \) -print0
}

# usage: find_tool NAME [PACKAGE]
# Sets $tool to a program: that of Debian 12, if its PACKAGE is named, or that of PyPI in an environment of its own.
# Returns 1 with a message if neither has the program.
find_tool()
{
  local requirement environment
  requirement=$(awk -v name="$1" '/^[^ ]/ { isIn = index($0, name "==") == 1 } isIn' Testing/lint-tools.txt)
  environment=build/$(sed 's/==/-/; s/ .*//; q' <<< "$requirement")
  if [ $# -eq 2 ] && [[ $(cat /etc/debian_version 2> /dev/null) == 12.* ]]; then
    tool=$2
    require_packages "$2"
    return
  fi
  tool=$environment/bin/$1
  require_packages python3 python3-venv
  if [ ! -x "$tool" ]; then
    if ! python3 -m venv "$environment" || ! "$environment/bin/pip" install -q --require-hashes \
      -r <(echo "$requirement"); then
      rm -rf "$environment"
      echo "!!!! SKIPPED: $1 could not be installed, so nothing was checked with it !!!!" >&2
      return 1
    fi
  fi
}

check_format()
{
  find_tool clang-format clang-format-14 || return 0
  list_files .h .cxx | xargs -0 "$tool" --dry-run --Werror
}

# Checks the width of code and comments. Help texts in raw strings may be wider.
check_columns()
{
  list_files .h .cxx | xargs -0 awk '
    FNR == 1 { raw = 0 }
    /R"[a-z]*\(/ { raw = 1 }
    !raw && length > 100 { print FILENAME ":" FNR ": has " length " columns, 100 are allowed"; wide = 1 }
    /\)[a-z]*"/ { raw = 0 }
    END { exit wide }'
}

check_spelling()
{
  find_tool codespell codespell || return 0
  "$tool" --config .codespellrc Module Plugin Examples Testing CMake Data Documentation ./*.md ./*.toml .github
}

check_python()
{
  find_tool ruff || return 0
  "$tool" check -q --no-cache .
}

check_shell()
{
  require_packages shellcheck
  list_files .sh | xargs -0 shellcheck --severity=style .ci/run
}

check_documents()
{
  Testing/Package/documents.py
}

# Checks the programs' texts for unidiomatic phrases.
check_texts()
{
  Testing/Package/strings.py --check
}

# Checks that the documentation's site builds without warnings.
check_site()
{
  local status=0
  Documentation/site/build.sh || status=$?
  if [ $status -eq 3 ]; then
    echo "!!!! SKIPPED: Sphinx could not be installed, so the site of the documentation was not built !!!!" >&2
    return 0
  fi
  return $status
}

# usage: run_clang_tidy CHECKS FILE... Removes CHECKS from the checks of .clang-tidy. No build is needed: the core is
# plain C++17.
run_clang_tidy()
{
  local checks=$1
  shift
  find_tool clang-tidy clang-tidy-14 || return 0
  require_packages g++
  # shellcheck disable=SC2016 # the inner shell expands it
  printf '%s\0' "$@" | xargs -0 -P "$(nproc)" -I '{}' bash -c '
    options=(-std=c++17 -IModule -I.)
    [[ $1 == *AVX2* ]] && options+=(-mavx2)
    "$3" --quiet --warnings-as-errors="*" --config-file=.clang-tidy --checks="$2" "$1" -- "${options[@]}" \
      2> /dev/null' _ '{}' "$checks" "$tool"
}

# Checks the sources of a folder together, as in a unity build: their headers are read once, and names that two of the
# sources define are reported, independently of other folders. Leaves out the kernels, which are compiled with other
# options.
check_tidy()
{
  local folder status=0
  folder=$(mktemp -d)
  find Module/Core -name '*.cxx' ! -name '*Kernels*' | sort |
    awk -v folder="$folder" '{ name = $0; sub("/[^/]*$", "", name); gsub("/", "-", name)
      print "#include \"" $0 "\"" > (folder "/" name ".cxx") }'
  run_clang_tidy '-clang-analyzer-*,-bugprone-suspicious-include' "$folder"/*.cxx \
    Module/Core/Field/Kernels/*.cxx || status=$?
  rm -r "$folder"
  return $status
}

check_analyze()
{
  local sources
  mapfile -t sources < <(find Module/Core -name '*.cxx')
  run_clang_tidy '-bugprone-*,-misc-*,-modernize-*,-performance-*,-readability-*' "${sources[@]}"
}

failed=()
for check in "${@:-format columns spelling python shell documents texts site tidy analyze}"; do
  # By default, $check is one argument with all names. Split it into words.
  for name in $check; do
    echo "== Checking: $name"
    "check_$name" || failed+=("$name")
  done
done
if [ ${#failed[@]} -gt 0 ]; then
  echo "These checks failed: ${failed[*]}. Repeat one with $0 NAME." >&2
  exit 1
fi
