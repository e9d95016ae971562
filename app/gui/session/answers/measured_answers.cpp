#include "app/gui/session/answers/measured_answers.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/questions/question.h"
#include "app/questions/review_question.h"
#include "core/study/provenance/study_hash.h"
#include "scenarios/project/results/saved_answer.h"

namespace noonmark {

namespace {

constexpr const char* measuredKey = "measured";  // in Project::view: a JSON list of names of results

// Whether the hash of the settings and the scenarios are all that the question depends on: which places or
// points were asked for is not in it.
bool isKnownByHash(const Answer& answer) {
    return answer.settings() && !answer.points() && &answer.question() != &byPlaceQuestion();
}

// Of a result of an earlier session, whose question is known by its hash, or by what a review states.
bool isReplaced(const SavedResult& read, const Answer& later) {
    if (const auto* review = later.as<ReviewAnswer>()) return isReviewOf(read, review->question);
    const MeasuredPart part = later.part();
    if (!isKnownByHash(later) || read.kind != later.question().key || read.scenario != part.scenario ||
        read.baseline != part.baseline)
        return false;
    const auto origin = readSavedOrigin(read);
    return origin && origin->weights == part.weights &&
           listHashes(*later.settings()).matches(origin->questionSha256);
}

bool isNameTaken(const Project& project, const std::string& name) {
    return std::ranges::any_of(project.results, [&](const auto& result) { return result->name == name; });
}

// The same object as long as the name is free, so that it is not written again.
std::shared_ptr<const SavedResult> underFreeName(std::shared_ptr<const SavedResult> result,
                                                 const Project& project) {
    if (!isNameTaken(project, result->name)) return result;
    SavedResult renamed = *result;
    renamed.name = freeName(project, ProjectPart::result, renamed.name);
    return std::make_shared<const SavedResult>(std::move(renamed));
}

std::vector<std::string> readNames(const std::string& text) {
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    std::vector<std::string> names;
    if (!json.is_array()) return names;
    for (const nlohmann::json& name : json)
        if (name.is_string()) names.push_back(name.get<std::string>());
    return names;
}

}  // namespace

MeasuredAnswer::MeasuredAnswer(KnownAnswer known, const ProjectSession& session, std::string name)
    : known_(std::move(known)), origin_(session), name_(std::move(name)) {}

MeasuredAnswer::MeasuredAnswer(std::shared_ptr<const SavedResult> read)
    : name_(read->name), saved_(std::move(read)) {}

bool MeasuredAnswer::isReplacedBy(const Answer& later) const {
    return known_.answer ? known_.answer->asksSameAs(later) : isReplaced(*saved_, later);
}

std::shared_ptr<const SavedResult> MeasuredAnswer::toSave() const {
    if (!origin_) return saved_;
    std::call_once(made_, [this] {
        SavedResult made = origin_->stated(known_.answer)->toSave(origin_->project());
        made.name = name_;
        saved_ = std::make_shared<const SavedResult>(std::move(made));
    });
    return saved_;
}

Project withMeasured(Project project, const MeasuredAnswers& measured) {
    std::vector<std::shared_ptr<const SavedResult>> results;
    std::size_t cells = 0;
    for (auto one = measured.rbegin(); one != measured.rend(); ++one) {
        auto result = (*one)->toSave();
        cells += result->layers.size() * result->grid.size();
        if (cells > maxMeasuredCells) break;
        results.push_back(std::move(result));
    }
    nlohmann::json names = nlohmann::json::array();
    for (auto result = results.rbegin(); result != results.rend(); ++result) {
        project.results.push_back(underFreeName(*result, project));
        names.push_back(project.results.back()->name);
    }
    if (!names.empty()) project.view[measuredKey] = names.dump();
    return project;
}

MeasuredAnswers takeMeasured(Project& project) {
    MeasuredAnswers measured;
    const auto text = project.view.find(measuredKey);
    if (text == project.view.end()) return measured;
    for (const std::string& name : readNames(text->second)) {
        const auto at = std::ranges::find(project.results, name, [](const auto& one) { return one->name; });
        if (at == project.results.end()) continue;
        measured.push_back(std::make_shared<const MeasuredAnswer>(*at));
        project.results.erase(at);
    }
    return measured;
}

}  // namespace noonmark
