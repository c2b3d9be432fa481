// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/page_command.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/file/button_file.h"
#include "model/file/text_file.h"
#include "playback/page/share_page.h"

namespace detent::playback {

namespace {

struct PageArguments {
  std::vector<std::string> buttons;
  std::string outputFile;
};

int runPage(const PageArguments& a, const Cancelled& cancelled) {
  std::vector<Button> buttons;
  for (const std::string& file : a.buttons) {
    if (cancelled && cancelled()) return fail(Failure::cancelled("page"));
    Result<Button> button = readButtonFile(file);
    if (!button) return fail(button.failure());
    buttons.push_back(std::move(*button));
  }
  Result<std::string> page = sharePage(buttons);
  if (!page) return fail(page.failure());
  if (Result<Done> written = writeTextFileAtomically(a.outputFile, *page); !written)
    return fail(written.failure());
  std::fprintf(stderr, "%s: %zu kB; open it in a browser, nothing else is needed\n", a.outputFile.c_str(),
               page->size() / 1000);
  return 0;
}

}  // namespace

void addPageCommand(CLI::App& program, Action& chosen) {
  CLI::App* app =
      program.add_subcommand("page", "Write buttons as one web page that anyone can open and press");
  const auto arguments = std::make_shared<PageArguments>();
  app->add_option("BUTTON", arguments->buttons, "One to nine *.button.json")->required();
  app->add_option("-o,--output", arguments->outputFile, "The page, *.html")->required();
  app->callback([&chosen, arguments] {
    chosen = [arguments](const Cancelled& cancelled) { return runPage(*arguments, cancelled); };
  });
}

}  // namespace detent::playback
