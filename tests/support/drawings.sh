# shellcheck shell=bash
# Five drawings for a library. Tests that are shell scripts source this file.

# make_drawings FOLDER: writes bean, star, corner, leaf and drop as SVG
make_drawings() {
  mkdir -p "$1"
  draw_svg "$1/bean" "M10 50 C10 10 90 10 90 50 C90 90 70 60 50 60 C30 60 10 90 10 50Z"
  draw_svg "$1/star" "M50 5 L61 38 L95 38 L67 59 L78 93 L50 72 L22 93 L33 59 L5 38 L39 38Z"
  draw_svg "$1/corner" "M10 10 H90 V45 H45 V90 H10Z"
  draw_svg "$1/leaf" "M10 90 C10 30 50 10 90 10 C90 60 60 90 10 90Z"
  draw_svg "$1/drop" "M50 5 C60 40 85 50 85 70 A35 25 0 0 1 15 70 C15 50 40 40 50 5Z"
}

draw_svg() { # PATH_WITHOUT_EXTENSION PATH_DATA
  echo "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><path fill='teal' d='$2'/></svg>" >"$1.svg"
}
