#!/bin/sh
# Looks whether the program runs on this image: nothing has to be installed.
set -eu
source=$(dirname "$0")
chmod +x "$source/raytree" "$source/run_autograder"
"$source/raytree" --version || {
    echo 'raytree does not run on this image; export again with --program FILE, a program that was built for it' >&2
    exit 1
}
