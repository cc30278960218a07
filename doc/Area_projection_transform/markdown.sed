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

# Symbols beside signs that are not ASCII, as in *c*²: Doxygen sees no emphasis there.
:symbol
s/(^|[^*])\*(σ|ρ|α|λ|[A-Za-z])\*([^*]|$)/\1<em>\2<\/em>\3/
t symbol

# Links to examples.
s/\]\(\.\.\/\.\.\/examples\/(Area_projection_transform\/[a-z_]*\.cpp)\)/](@ref \1)/g
s/\]\(\.\.\/\.\.\/examples\/Area_projection_transform\)/](examples.html)/g
