// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPT_FILE_LIST_H
#define MAPT_FILE_LIST_H

#include <string>
#include <vector>

namespace mapt {

/// the names of meshes that some arguments and the lines of a list (a file, "-": stdin, empty: none) stand for,
/// in this order. In the place of a folder are the meshes in it and below it, in the order of their names.
///
/// Whether files exist is not looked at.
/// \throw Input_error if the list or a folder cannot be read, or there is no mesh in it
/// \throw Usage_error if a name comes twice
std::vector<std::string> list_files(const std::vector<std::string>& arguments,
                                    const std::string& list);

} // namespace mapt

#endif // MAPT_FILE_LIST_H
