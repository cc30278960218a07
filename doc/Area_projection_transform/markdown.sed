# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Pages are written so that they read well where the repository is hosted; this turns what Doxygen says differently.

# Formulas: blocks of ```math, and $`…`$ in a line.
/^```math$/,/^```$/ {
  s/^```math$/\\f[/
  s/^```$/\\f]/
  b
}

# Code stays as it is.
/^```/,/^```$/b
/^    /b

s/\$`([^`]*)`\$/\\f$\1\\f$/g

# Bold around code.
s/\*\*(`[^*]*`)\*\*/<b>\1<\/b>/g

# Symbols beside signs that are not ASCII, as in *c*², or beside bold ones: Doxygen sees no emphasis there.
s/\*([A-Za-z])\*\*\*([A-Za-z])\*\*/<em>\1<\/em><b>\2<\/b>/g
:symbol
s/(^|[^*])\*(σ|ρ|α|λ|[A-Za-z])\*([^*]|$)/\1<em>\2<\/em>\3/
t symbol

# Links to examples.
s/\[`?([a-z_ ]*(\.cpp)?)`?\]\(\.\.\/\.\.\/examples\/Area_projection_transform\/([a-z_]*\.cpp)\)/@ref \3 "\1"/g
s/\[([a-z ]*)\]\(\.\.\/\.\.\/examples\/Area_projection_transform\)/@ref PkgAreaProjectionTransformExamples "\1"/g
