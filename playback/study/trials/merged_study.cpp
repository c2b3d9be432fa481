// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>
#include <tuple>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/file/text_file.h"
#include "playback/study/trials/study_design.h"

namespace detent::playback {

namespace {

namespace fs = std::filesystem;

Failure cannotMerge(const fs::path& folder, Message problem, const Message& remedy) {
  return {FailureCode::wrongUsage, folder.string(), "", std::move(problem), remedy};
}

/// Returns true if answers of both studies are comparable; seeds and programs may differ.
bool comparable(const Study& a, const Study& b) {
  const auto taskOf = [](const StudyDesign& d) {
    return std::tie(d.kind, d.targets, d.modes, d.feel, d.quantity, d.scale, d.task, d.intervals_s,
                    d.windows_s, d.run_s, d.trials, d.practice, d.pairsEach, d.sound.source, d.sound.sha256,
                    d.sound.level_dB, d.sound.delay_ms);
  };
  const auto sameButtons = [&] {
    if (a.buttons.size() != b.buttons.size() || a.stimuli.size() != b.stimuli.size()) return false;
    for (std::size_t i = 0; i < a.buttons.size(); ++i)
      if (a.buttons[i].label != b.buttons[i].label || a.buttons[i].sha256 != b.buttons[i].sha256)
        return false;
    for (std::size_t i = 0; i < a.stimuli.size(); ++i)
      if (a.stimuli[i].sha256 != b.stimuli[i].sha256) return false;
    return true;
  };
  return taskOf(a.design) == taskOf(b.design) && a.profileSha256 == b.profileSha256 && sameButtons();
}

Result<Done> checkSites(const std::vector<std::string>& sites, const fs::path& folder) {
  std::set<std::string> names;
  for (const std::string& site : sites) {
    if (!checkParticipantId(site))
      return cannotMerge(folder, Message("\"%1\" is not a site name", site),
                         Message("Give --sites names made of letters, digits, - and _"));
    if (!names.insert(site).second)
      return cannotMerge(folder, Message("two sites are called \"%1\"", site),
                         Message("Give --sites a different name for each study"));
  }
  return Done{};
}

}  // namespace

fs::path siteFolder(const fs::path& folder, const std::string& site) { return folder / "sites" / site; }

Result<Study> openSites(const std::vector<std::string>& sites, const fs::path& folder) {
  Result<Study> merged = openStudy(siteFolder(folder, sites.front()));
  for (const std::string& site : sites) {
    const Result<Study> study = openStudy(siteFolder(folder, site));
    if (!study) return study.failure();
    if (!study->sites.empty())
      return cannotMerge(siteFolder(folder, site), Message("this study is already a merged study"),
                         Message("Merge the studies of its sites"));
    if (!comparable(*merged, *study))
      return cannotMerge(
          siteFolder(folder, site),
          Message("this study has other questions or other buttons than \"%1\"", sites.front()),
          Message("Merge copies of one study"));
    if (merged->unfinished != study->unfinished)
      return cannotMerge(
          siteFolder(folder, site),
          Message("this study and \"%1\" have different rules for participants who did not finish",
                  sites.front()),
          Message("Merge studies of one plan"));
  }
  merged->folder = folder;
  merged->name = fs::weakly_canonical(folder).filename().string();
  merged->sites = sites;
  return merged;
}

Result<Study> mergeStudies(const std::vector<fs::path>& studies, std::vector<std::string> sites,
                           const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error))
    return cannotMerge(folder, Message("the folder exists already"),
                       Message("Name a new folder; a study is never overwritten"));
  if (sites.empty())
    for (const fs::path& study : studies) sites.push_back(fs::weakly_canonical(study).filename().string());
  if (sites.size() != studies.size())
    return cannotMerge(folder, Message("there are %1 names for %2 studies", sites.size(), studies.size()),
                       Message("Give --sites one name for each study"));
  if (Result<Done> ok = checkSites(sites, folder); !ok) return ok.failure();
  fs::path draft = folder;
  draft += ".part";
  fs::remove_all(draft, error);
  fs::create_directories(draft / "sites", error);
  for (std::size_t i = 0; i < studies.size() && !error; ++i)
    fs::copy(studies[i], siteFolder(draft, sites[i]), fs::copy_options::recursive, error);
  Result<Study> study =
      error ? Result<Study>(Failure{FailureCode::unreadableInput, folder.string(), "",
                                    Message("the folder cannot be created (%1)", error.message()),
                                    Message("Check the folders and the free space")})
            : openSites(sites, draft);
  if (study) {
    const nlohmann::ordered_json json{{"format", "detent-merged-study"}, {"version", 1}, {"sites", sites}};
    const Result<Done> written =
        writeTextFileAtomically((draft / "study.json").string(), jsonText(json, 2) + "\n");
    if (written) fs::rename(draft, folder, error);
    if (written && !error) return openStudy(folder);
    study = written ? Failure{FailureCode::unreadableInput, folder.string(), "",
                              Message("the folder cannot be created (%1)", error.message()),
                              Message("Check the folder in which it should be created")}
                    : written.failure();
  }
  fs::remove_all(draft, error);
  return study;
}

}  // namespace detent::playback
