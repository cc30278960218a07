// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cost.h"

#include "memory.h"
#include "text.h"

namespace mapt {

void report_cost(const Times& times, Console& console)
{
  console.report["seconds"] = {{"read", times.reading},
                               {"compute", times.computing},
                               {"write", times.writing},
                               {"total", times.reading + times.computing + times.writing}};
  console.report["peak_memory_bytes"] = peak_memory();
  console.row("time", to_text(times.reading, 2) + " s to read, " + to_text(times.computing, 2) +
                          " s to compute, " + to_text(times.writing, 2) + " s to write");
  console.row("memory", bytes_to_text(peak_memory()) + " at the peak");
}

} // namespace mapt
