# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Pages are written so that they read well where the repository is hosted; this turns what Doxygen says differently.

# Formulas: $`…`$ in a line, and blocks of ```math.
s/\$`([^`]*)`\$/\\f$\1\\f$/g
/^```math$/,/^```$/ {
  s/^```math$/\\f[/
  s/^```$/\\f]/
}

# Links to examples.
s/\]\(\.\.\/\.\.\/examples\/(Area_projection_transform\/[a-z_]*\.cpp)\)/](@ref \1)/g
s/\]\(\.\.\/\.\.\/examples\/Area_projection_transform\)/](examples.html)/g
