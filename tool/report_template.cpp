// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report_template.h"

// The assembler puts the bytes of a file into the program. MAPT_VIEWER_PAGE is its name.
#ifdef __APPLE__
#define MAPT_READ_ONLY_DATA ".const_data"
#define MAPT_SYMBOL(name) "_" name
#else
#define MAPT_READ_ONLY_DATA ".section .rodata"
#define MAPT_SYMBOL(name) name
#endif

// clang-format off
__asm__(MAPT_READ_ONLY_DATA "\n"
        ".global " MAPT_SYMBOL("mapt_viewer_page_begin") "\n"
        ".global " MAPT_SYMBOL("mapt_viewer_page_end") "\n"
        MAPT_SYMBOL("mapt_viewer_page_begin") ":\n"
        ".incbin \"" MAPT_VIEWER_PAGE "\"\n"
        MAPT_SYMBOL("mapt_viewer_page_end") ":\n"
        ".byte 0\n"
        ".text\n");
// clang-format on

extern "C" const char mapt_viewer_page_begin[];
extern "C" const char mapt_viewer_page_end[];

namespace mapt {

std::string_view report_template()
{
  return {mapt_viewer_page_begin,
          static_cast<std::size_t>(mapt_viewer_page_end - mapt_viewer_page_begin)};
}

} // namespace mapt
