// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/station/station_page.h"

#include <algorithm>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/version.h"
#include "playback/page/button_numbers.h"
#include "playback/page/page_parts.h"
#include "playback/page/page_text.h"
#include "playback/study/station/station_parts.h"
#include "playback/study/trials/participant_session.h"

namespace detent::playback {

namespace {

using StationJson = nlohmann::ordered_json;

constexpr std::size_t mostPeople = 200;

constexpr const char* command = "study station";  // not translated

Failure noStation(Message problem, const Message& remedy) {
  return {FailureCode::wrongUsage, command, "", std::move(problem), remedy};
}

Result<Done> checkForBrowsers(const Study& study) {
  if (!hasStation())
    return noStation(
        Message("this build of Detent cannot make a web page on which buttons can be pressed"),
        Message("Install a build of Detent that can make web pages. If you build Detent yourself, first "
                "install clang-14, lld-14, wasi-libc, libc++-14-dev-wasm32 and libclang-rt-14-dev-wasm32"));
  if (!study.sites.empty())
    return noStation(Message("this is the merged study of several sites: nobody answers in it"),
                     Message("Give the study file of one site only"));
  if (study.design.kind == StudyKind::timing)
    return noStation(Message("a timing study needs exact times, which a browser does not give"),
                     Message("Run the study with detent-play study run or in detent-edit"));
  if (study.profile)
    return noStation(
        Message("the study was made for a device profile, and a browser's device is unknown"),
        Message("Make a study without a device profile, or run this one with detent-play study run or in "
                "detent-edit"));
  return checkStimuli(study);
}

/// "https://host:port" of an address, for the page's content security policy.
Result<std::string> originOf(const std::string& address) {
  const std::size_t host = address.find("://") + 3;
  const std::size_t end = std::min(address.find_first_of("/?#", host), address.size());
  const bool web = address.starts_with("https://") || address.starts_with("http://");
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == ':' || c == '-' || c == '[' || c == ']';
  };
  if (web && end > host &&
      std::all_of(address.begin() + static_cast<std::ptrdiff_t>(host),
                  address.begin() + static_cast<std::ptrdiff_t>(end), plain))
    return address.substr(0, end);
  return Failure{FailureCode::wrongUsage, Subject::option("--post"), "",
                 Message("\"%1\" is not the address of a web server", address),
                 Message("Give an address such as https://lab.example/answers")};
}

/// Records of the page's participants, each with a place: the planned one, or one after all who have begun.
Result<std::vector<ParticipantRecord>> newPeople(const Study& study, const std::vector<std::string>& ids) {
  if (ids.empty() || ids.size() > mostPeople)
    return noStation(
        Message("a web page is for 1 to %1 participants, but %2 were given", mostPeople, ids.size()),
        Message("Name the participants with --participants, separated by commas"));
  const Result<PlannedPlaces> plan = placesOf(study.folder);
  if (!plan) return plan.failure();
  const Result<std::vector<ParticipantRecord>> begun = readParticipants(study);
  if (!begun) return begun.failure();
  std::set<std::string> spoken;
  std::vector<ParticipantRecord> people;
  for (const std::string& id : ids) {
    Result<ParticipantRecord> person = ParticipantSession::toOpen(study, id, SessionStart{});
    if (!person) return person.failure();
    if (!person->plan.empty())
      return noStation(Message("the participant %1 has begun already", id),
                       Message("Give another participant id"));
    if (!spoken.insert(spokenId(id)).second)
      return noStation(
          Message("the participant %1 is named twice, or the id is too similar to another one", id),
          Message("Give ids that sound different when read aloud"));
    person->place = placeOf(*plan, id, begun->size() + people.size());
    person->plan = planTrials(study, id, person->place);
    people.push_back(*std::move(person));
  }
  return people;
}

StationJson jsonOfPerson(const Study& study, const ParticipantRecord& person) {
  StationJson trials = StationJson::array();
  for (const Trial& trial : person.plan)
    trials.push_back({{"number", trial.number},
                      {"practice", trial.practice},
                      {"mode", nameOf(trial.mode)},
                      {"choices", feltButtons(study.design, trial)},
                      {"target", trial.target},
                      {"rest_before", trial.breakBefore}});
  return {{"id", person.participant}, {"header", headerOfBrowser(study, person)}, {"trials", trials}};
}

StationJson stimuliAsJson(const Study& study) {
  StationJson list = StationJson::array();
  for (const StudyStimulus& stimulus : study.stimuli) {
    const PlaybackSettings settings = settingsFor(study, stimulus.button, stimulus.mode);
    list.push_back(
        {{"button", stimulus.button},
         {"mode", nameOf(stimulus.mode)},
         {"numbers", base64(numbersOf(study.buttons[stimulus.button].button))},
         {"settings",
          {settings.feel == Feel::clear ? 1 : 0, static_cast<int>(settings.mode), settings.grainAmplitude,
           settings.jumpAmplitudePerArea_per_mJ, settings.faintestJump}}});
  }
  return list;
}

/// Base64 of little-endian numbers, as a browser reads them; null: no sound.
StationJson soundAsJson(const PressSound& sound) {
  if (!sound.audible()) return nullptr;
  return {{"rendered", sound.rendered},
          {"samples", base64({reinterpret_cast<const char*>(sound.samples.data()),
                              sound.samples.size() * sizeof(float)})},
          {"rate", sound.sampleRate_Hz},
          {"level_dB", sound.level_dB},
          {"delay_s", sound.delay_s}};
}

/// The consent texts of all available languages, English first.
Result<StationJson> consentsAsJson(const Study& study) {
  std::set<std::string> languages;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(study.folder, error)) {
    const std::string name = entry.path().filename().string();
    constexpr std::string_view front = "consent.", ending = ".txt";
    if (name.starts_with(front) && name.ends_with(ending) && name.size() > front.size() + ending.size())
      languages.insert(name.substr(front.size(), name.size() - front.size() - ending.size()));
  }
  languages.erase("en");
  StationJson texts = StationJson::array();
  std::vector<std::string> order{"en"};
  order.insert(order.end(), languages.begin(), languages.end());
  for (const std::string& language : order) {
    const Result<ConsentText> text = consentIn(study.folder, language);
    if (!text && language == "en" && order.size() > 1) continue;  // there are texts only in other languages
    if (!text) return text.failure();
    texts.push_back({{"language", text->language}, {"text", text->text}, {"sha256", text->sha256}});
  }
  return texts;
}

}  // namespace

bool hasStation() { return !station_parts::engine.empty(); }

Result<std::string> stationPage(const Study& study, const StationSettings& settings) {
  if (Result<Done> ok = checkForBrowsers(study); !ok) return ok.failure();
  std::string connect = "'none'";
  if (!settings.postTo.empty()) {
    Result<std::string> origin = originOf(settings.postTo);
    if (!origin) return origin.failure();
    connect = *std::move(origin);
  }
  const Result<std::vector<ParticipantRecord>> people = newPeople(study, settings.participants);
  if (!people) return people.failure();
  Result<StationJson> consents = consentsAsJson(study);
  if (!consents) return consents.failure();
  StationJson persons = StationJson::array(), labels = StationJson::array(), levels = StationJson::array();
  for (const ParticipantRecord& person : *people) persons.push_back(jsonOfPerson(study, person));
  for (const StudyButton& button : study.buttons) labels.push_back(button.label);
  for (const StudyLevel& level : study.levels)
    levels.push_back(
        {{"button", level.button}, {"reference", level.reference}, {"increase", level.increase}});
  Result<PressSound> sound = pressSoundOf(study);
  if (!sound) return sound.failure();
  const StationJson data{
      {"title", study.name},
      {"sha256", study.sha256},
      {"program", version()},
      {"kind", nameOf(study.design.kind)},
      {"scale", study.design.kind == StudyKind::rating ? nameOf(study.design.scale) : ""},
      {"physical", study.design.targets == TargetKind::physicalButton},
      {"listening", nameOf(settings.listening)},
      {"post", settings.postTo.empty() ? StationJson(nullptr) : StationJson(settings.postTo)},
      {"people", persons},
      {"labels", labels},
      {"levels", levels},
      {"sound", soundAsJson(*sound)},
      {"stimuli", stimuliAsJson(study)},
      {"consents", *std::move(consents)},
      {"words", StationJson::parse(station_parts::words)},
      {"comparison",
       study.design.kind == StudyKind::threshold ? nameOf(study.design.quantity) : nameOf(study.design.kind)},
      {"engine", base64(station_parts::engine)}};
  const std::string engineScript(page_parts::engineScript);
  return filled(station_parts::html,
                {{"@TITLE@", insideElement(study.name)},
                 {"@CONNECT@", connect},
                 {"@STYLE@", std::string(page_parts::style) + std::string(station_parts::style)},
                 {"@VERSION@", version()},
                 {"@FEEL@", std::string(feels.word(study.design.feel))},
                 {"@DATA@", insideScript(jsonText(data))},
                 {"@ENGINE@", engineScript},
                 {"@WORKLET@", engineScript + std::string(station_parts::worklet)},
                 {"@SCRIPT@", std::string(station_parts::script)}});
}

}  // namespace detent::playback
