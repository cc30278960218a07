// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"

#include "config_file.h"
#include "errors.h"
#include "text.h"

#include <CGAL/Area_projection_transform/IO/number_text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <memory>
#include <sstream>
#include <system_error>

namespace mapt {

namespace {

// Own validators, because CLI11's print bounds of 309 digits.
template <class Predicate>
CLI::Validator number_check(const std::string& requirement, Predicate is_good)
{
  return CLI::Validator(
      [requirement, is_good](std::string& text) {
        double value = 0;
        const bool is_number = CLI::detail::lexical_cast(text, value);
        return is_number && is_good(value) ? std::string() : text + " is not " + requirement;
      },
      std::string());
}

// Breaks lines between words.
std::string wrapped(const std::string& text, std::size_t width)
{
  std::istringstream words(text);
  std::string result, word;
  std::size_t column = 0;
  while(words >> word) {
    if(column > 0 && column + 1 + word.size() > width) {
      result += '\n';
      column = 0;
    }
    result += (column > 0 ? " " : "") + word;
    column += (column > 0 ? 1 : 0) + word.size();
  }
  return result;
}

constexpr std::size_t help_width = 80;
constexpr std::size_t help_column = 28;

// CLI11's own writes lines of any length, and lists what excludes what.
class Help_formatter : public CLI::Formatter
{
public:
  Help_formatter() { column_width(help_column); }

  std::string make_option_opts(const CLI::Option* option) const override
  {
    const std::string type = option->get_positional() ? "" : option->get_type_name();
    return type.empty() ? "" : " " + type.substr(0, type.find(':'));
  }

  std::string make_option_desc(const CLI::Option* option) const override
  {
    const std::string value = option->get_default_str();
    return wrapped(option->get_description() + (value.empty() ? "" : " (default: " + value + ")"),
                   help_width - help_column);
  }

  std::string make_description(const CLI::App* app) const override
  {
    std::istringstream paragraphs(app->get_description());
    std::string result, paragraph;
    while(std::getline(paragraphs, paragraph))
      result += wrapped(paragraph, help_width) + '\n';
    return result + '\n';
  }
};

std::string nearest_option(const CLI::App& app, const std::string& word)
{
  std::vector<std::string> names;
  for(const CLI::Option* option : app.get_options())
    for(const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  const std::string nearest = nearest_word(word, names);
  return nearest.empty() ? "see " + app.get_name() + " --help" : "did you mean " + nearest + "?";
}

[[noreturn]] void fail_for_extras(const CLI::App& app)
{
  const std::vector<std::string> extras = app.remaining();
  const std::string& word = extras.empty() ? std::string() : extras.front();
  if(word.empty() || word[0] != '-')
    throw Usage_error("'" + word + "' is one argument too many: see " + app.get_name() + " --help");
  throw Usage_error("there is no option " + word + ": " +
                    nearest_option(app, word.substr(0, word.find('='))));
}

// CLI11 tells of words that are no options by a text only.
[[noreturn]] void fail_for_config(const CLI::App& app, std::string what)
{
  const std::string unknown = "INI was not able to parse ";
  if(what.rfind(unknown, 0) == 0) {
    const std::string word = what.substr(unknown.size());
    what = "there is no option " + CGAL::Area_projection::IO::internal::in_quotes(word) + ": " +
           nearest_option(app, "--" + word);
  }
  throw Usage_error("--config " + config_file_of(app) + ": " + what);
}

std::string one_line(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

} // namespace

Command_line::Command_line(const std::string& name, const std::string& description)
    : CLI::App(description, name)
{
  formatter(std::make_shared<Help_formatter>());
}

CLI::Validator positive_number()
{
  // No shape that can be read asks for others.
  return number_check("a positive number from 1e-30 to 1e30",
                      [](double value) { return value >= 1e-30 && value <= 1e30; });
}

CLI::Validator number_from(double least, double most)
{
  std::ostringstream requirement;
  requirement << "from " << least << " to " << most;
  return number_check(requirement.str(),
                      [=](double value) { return value >= least && value <= most; });
}

CLI::Validator number_between_0_and_1()
{
  return number_check("greater than 0 and less than 1",
                      [](double value) { return value > 0 && value < 1; });
}

CLI::Validator whole_number()
{
  return CLI::Validator( // CLI11 takes -1 for the largest one
      [](std::string& text) {
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool is_good = error == std::errc() && end == text.data() + text.size();
        return is_good ? std::string() : text + " is not a whole number from 0 to 2^64 - 1";
      },
      std::string());
}

CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& word,
                        const std::vector<std::string>& words, const std::string& description)
{
  return app.add_option(name, word, description)->check(CLI::IsMember(words))->type_name("WORD");
}

CLI::Option* add_bytes_option(CLI::App& app, const std::string& name, double& bytes,
                              const std::string& description)
{
  const auto take = [&bytes](const std::string& text) {
    if(!bytes_from_text(text, bytes))
      throw CLI::ValidationError("--max-memory",
                                 text + " is not a number of bytes such as 500M or 2G");
  };
  return app.add_option_function<std::string>(name, take, description)
      ->type_name("BYTES")
      ->default_str(bytes_to_text(bytes));
}

CLI::Option* add_list_option(CLI::App& app, const std::string& name, std::vector<double>& values,
                             const std::string& description)
{
  // Without allow_extra_args(false) the list would take the arguments after it, too.
  return app.add_option(name, values, description)
      ->type_name("LENGTH,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(positive_number());
}

void add_console_options(CLI::App& app, Console& console)
{
  app.add_flag("--json", console.is_json,
               "print one JSON object in place of the table, on failure, too")
      ->group("Messages");
  app.add_flag("-q,--quiet", console.is_quiet, "print errors only")->group("Messages");
  app.add_flag("-v,--verbose", console.is_verbose, "say more about what is going on")
      ->group("Messages");
  app.set_config("--config", "", "read options from a file with lines such as 'threads = 2'")
      ->type_name("FILE")
      ->group("Messages");
  app.config_formatter(std::make_shared<Config_reader>());
  app.allow_config_extras(CLI::config_extras_mode::error);
  app.set_version_flag("--version", "mapt " MAPT_VERSION, "print the version")->group("Messages");
  app.set_help_flag("-h,--help", "print this help")->group("Messages");
}

void add_thread_option(CLI::App& app, Common_options& options)
{
  app.add_option("-j,--threads", options.threads, "number of threads")
      ->type_name("NUMBER")
      ->default_str("all")
      ->check(CLI::Validator(
          [](std::string& text) {
            double value = 0;
            const bool is_good = CLI::detail::lexical_cast(text, value) && value >= 1 &&
                                 value <= 4096 && value == std::floor(value);
            return is_good ? std::string() : text + " is not a number of threads (1 to 4096)";
          },
          std::string()))
      ->group("Computation");
}

void add_reading_options(CLI::App& app, Common_options& options)
{
  add_orientation_options(app, options.reading);
  add_normals_option(app, options.reading);
}

void add_orientation_options(CLI::App& app, Reading_options& reading)
{
  app.add_flag("--orient", reading.orient,
               "turn faces over until neighbours agree about the outside")
      ->group("Mesh");
  app.add_flag("--flip", reading.flip, "turn all faces (or normals) over")->group("Mesh");
}

void add_normals_option(CLI::App& app, Reading_options& reading)
{
  app.add_flag("--estimate-normals", reading.estimate_normals,
               "of points that have none: from their neighbours, outward")
      ->group("Mesh");
}

bool parse(CLI::App& app, std::vector<std::string> arguments)
{
  std::reverse(arguments.begin(), arguments.end()); // as CLI11 wants them
  try {
    app.parse(arguments);
    check_config_stays(app);
    return true;
  } catch(const CLI::CallForHelp&) {
    std::cout << app.help();
  } catch(const CLI::CallForVersion& version) {
    std::cout << version.what() << '\n';
  } catch(const CLI::ExtrasError&) {
    fail_for_extras(app);
  } catch(const CLI::FileError&) {
    fail_for_config(app, "cannot be read");
  } catch(const CLI::ConfigError& error) {
    fail_for_config(app, one_line(error.what()));
  } catch(const CLI::RequiredError& error) {
    throw Usage_error(one_line(error.what()) + ": see " + app.get_name() + " --help");
  } catch(const CLI::ParseError& error) {
    throw Usage_error(one_line(error.what()));
  }
  return false;
}

} // namespace mapt
