// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/python/core/reading.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "importer/program/arguments.h"
#include "importer/program/report_json.h"

namespace detent::python {
namespace {

/// The fault of the arguments, without the following line that refers to --help.
std::string whatIsWrong(const std::string& message) { return message.substr(0, message.find("\nRun with ")); }

}  // namespace

importer::ImportRequest requestOf(const std::vector<std::string>& options) {
  std::vector<const char*> words{"detent-import"};
  for (const std::string& option : options) words.push_back(option.c_str());
  words.insert(words.end(), {"--", "INPUT"});  // the file's name is given with every call
  std::ostringstream out, err;
  const auto parsed = importer::parseArguments(static_cast<int>(words.size()), words.data(), out, err);
  if (!parsed.arguments)
    throw Refusal({static_cast<int>(FailureCode::wrongUsage), whatIsWrong(err.str()), {}, {}});
  return parsed.arguments->request;
}

ReadButton readGraph(importer::ImportRequest request, const std::string& path, const Cancelled& cancelled) {
  request.path = path;
  importer::Progress progress;
  progress.cancelled = cancelled;
  auto session = importer::ImportSession::open(path, request.limits);
  if (!session)
    throw Refusal(Refused::from(session.failure(), importer::failureJson(session.failure(), path)));
  auto [report, evidence, question, interpretations] = session->attempt(request, progress);
  if (!report) {
    const auto switches = evidence ? evidence->switches : std::vector<importer::PlotSwitch>{};
    throw Refusal(
        Refused::from(report.failure(), importer::failureJson(report.failure(), path, switches, question)));
  }
  std::string json = importer::reportJson(*report, path, {});
  return {std::move(report->button), std::move(json)};
}

struct ReadMany::Shared : Errand {
  /// Queue entry of one file.
  struct Input {
    std::string path;
    std::shared_ptr<Errand> over = std::make_shared<Errand>();
    Answer<ReadButton> answer;
  };
  std::vector<Input> inputs;
  importer::ImportRequest request;
  std::atomic<std::size_t> begun{0};

  void readOn() {
    for (std::size_t at = begun++; at < inputs.size(); at = begun++) {
      Input& input = inputs[at];
      if (!cancelled())
        input.answer = answerOf<ReadButton>([&] {
          return readGraph(request, input.path,
                           [this, &input] { return cancelled() || input.over->cancelled(); });
        });
      input.over->finish();
    }
  }
};

ReadMany::ReadMany(const std::vector<std::string>& paths, const importer::ImportRequest& request,
                   std::size_t jobs)
    : shared_(std::make_shared<Shared>()) {
  shared_->request = request;
  for (const std::string& path : paths) shared_->inputs.emplace_back().path = path;
  for (std::size_t job = 0; job < std::min(jobs, paths.size()); ++job)
    begin([shared = shared_] { shared->readOn(); });
}

Answer<ReadButton> ReadMany::next() {
  Shared::Input& input = shared_->inputs.at(given_++);
  try {
    await(*input.over);
  } catch (...) {
    stop();
    throw;
  }
  return std::move(input.answer);
}

void ReadMany::stop() { shared_->cancel(); }

}  // namespace detent::python
