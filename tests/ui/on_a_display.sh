#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a program that needs a display: on the one there is, else on a virtual one.
if [ -n "$DISPLAY" ]; then
  exec "$@"
fi
if ! command -v xvfb-run >/dev/null; then
  echo "on_a_display.sh: no DISPLAY and no xvfb-run (Debian package xvfb)" >&2
  exit 1
fi
exec xvfb-run -a -s "-screen 0 1920x1080x24" "$@"
