#include "app/gui/session/answers/answer_viewer.h"

#include <QDateTime>
#include <QObject>
#include <algorithm>
#include <array>
#include <map>
#include <memory>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/gui/session/study/region_text.h"
#include "app/questions/glazing_question.h"
#include "app/questions/saved_question.h"
#include "scenarios/project/results/saved_answer.h"

namespace noonmark {

namespace {

std::optional<AnswerLayer> layerOfAny(const std::shared_ptr<const Answer>& answer) {
    const auto field = answer->field();
    if (!field) return std::nullopt;
    return markMissingRuns({.map = std::shared_ptr<const ShadowField>(answer, field.get())});
}

std::vector<ResultRow> rowsOfAny(const Answer& answer, ShownAs) { return figureRows(answer.figures()); }

const AnswerViewer anyViewer{.layer = layerOfAny, .rows = rowsOfAny};

/// What titles are made of, besides scenarios and weights.
struct TitleSource {
    const AnswerViewer& viewer;
    std::string question{};  ///< its label
    std::string rule{};      ///< its name; empty: the answer is no review
};

TitleSource sourceOf(const Answer& answer) {
    const AnswerViewer& viewer = viewerOf(answer);
    return {viewer, std::string(answer.question().label), viewer.rule ? viewer.rule(answer) : std::string()};
}

Sentence makeTitle(const TitleSource& source, const MeasuredPart& part) {
    if (source.viewer.title) return source.viewer.title(part);
    if (!source.rule.empty())
        return {NM_TEXT("%1: %2 compared with %3"), {source.rule, part.scenario, part.baseline}};
    return {NM_TEXT("%1 of %2"), {source.question, part.scenario}};
}

// All arguments are names, of which the program gives some: the existing city, rules, questions, weights.
std::string localName(const std::string& name, const MeasuredPart& part) {
    if (name == part.scenario || name == part.baseline) return scenarioName(name).toStdString();
    const std::string rule = ruleName(name).toStdString();
    return rule == name ? weightName(name).toStdString() : rule;
}

QString localText(const Sentence& sentence, const MeasuredPart& part) {
    std::vector<std::string> names;
    for (const Sentence::Argument& one : sentence.arguments)
        names.push_back(localName(std::get<std::string>(one), part));
    return QString::fromStdString(fillIn(translated(sentence.source).toStdString(), names));
}

std::string englishText(const Sentence& sentence) {
    std::vector<std::string> names;
    for (const Sentence::Argument& one : sentence.arguments) names.push_back(std::get<std::string>(one));
    return fillIn(sentence.source, names);
}

std::string withDay(const std::string& title, const std::string& day) {
    return day.empty() ? title : title + ", " + day;
}

std::string dayOf(const Answer& answer) {
    return answer.settings() ? formatText(answer.settings()->period.start) : std::string();
}

// `name`: the English text, maybe with the number of a further answer: "Study of Tower, 2026-06-21 (2)".
std::optional<QString> translatedName(const std::string& name, const Sentence& title,
                                      const MeasuredPart& part, const std::string& day) {
    const std::string english = withDay(englishText(title), day);
    if (!name.starts_with(english)) return std::nullopt;
    const std::string number = name.substr(english.size());
    const bool isNumber = number.empty() || (number.starts_with(" (") && number.ends_with(')'));
    if (!isNumber) return std::nullopt;
    return QString::fromStdString(withDay(localText(title, part).toStdString(), day) + number);
}

QString translatedName(const std::string& name, const TitleSource& source, const MeasuredPart& part,
                       const std::string& day) {
    if (const auto text = translatedName(name, makeTitle(source, part), part, day)) return *text;
    if (source.viewer.name)
        if (const auto text = translatedName(name, source.viewer.name(part), part, day)) return *text;
    return QString::fromStdString(name);
}

}  // namespace

QString titleOf(const Answer& answer) {
    const auto ofSaved = viewerOf(answer).savedTitle;
    const MeasuredPart part = answer.part();
    return ofSaved ? ofSaved(answer) : localText(makeTitle(sourceOf(answer), part), part);
}

QString listedName(const Answer& answer) {
    return QString::fromStdString(withDay(titleOf(answer).toStdString(), dayOf(answer)));
}

std::string storedName(const Answer& answer) {
    return withDay(englishText(makeTitle(sourceOf(answer), answer.part())), dayOf(answer));
}

std::string nameToSave(const Answer& answer) {
    const auto make = viewerOf(answer).name;
    return make ? withDay(englishText(make(answer.part())), dayOf(answer)) : storedName(answer);
}

QString shownName(const MeasuredAnswer& measured) {
    const auto& answer = measured.known().answer;
    return answer ? translatedName(measured.name(), sourceOf(*answer), answer->part(), dayOf(*answer))
                  : shownName(measured.toSave());
}

namespace {

// What the name of a saved result is made of, besides its own columns.
struct NameParts {
    std::optional<TimeWeights> weights;
    std::string day;
    std::string rule;  ///< of a review
};

// Words, which older versions state alone, begin with it: "2026-06-21, 1 day, ...".
std::string firstDayOf(const StatedPeriod& period) {
    return period.asked ? formatText(period.asked->start) : period.words.substr(0, period.words.find(','));
}

std::optional<NameParts> readNameParts(const SavedResult& result) {
    const auto origin = readSavedOrigin(result);
    if (!origin) return std::nullopt;
    return NameParts{origin->weights, firstDayOf(origin->period), origin->rule};
}

QString shownName(const SavedResult& result, const std::optional<NameParts>& parts) {
    if (!parts) return QString::fromStdString(result.name);
    return translatedName(result.name, {viewerOf(result.kind), {}, parts->rule},
                          {result.scenario, result.baseline, {}, parts->weights}, parts->day);
}

}  // namespace

QString shownName(const SavedResult& result) { return shownName(result, readNameParts(result)); }

// Lists ask for all names at each change of the project; a result of thousands of places holds megabytes.
QString shownName(const std::shared_ptr<const SavedResult>& result) {
    static std::map<std::weak_ptr<const SavedResult>, std::optional<NameParts>, std::owner_less<>> known;
    const auto found = known.find(result);
    if (found != known.end()) return shownName(*result, found->second);
    std::erase_if(known, [](const auto& one) { return one.first.expired(); });
    return shownName(*result, known.emplace(result, readNameParts(*result)).first->second);
}

const AnswerViewer& viewerOf(const Answer& answer) { return viewerOf(answer.question().key); }

const AnswerViewer& viewerOf(std::string_view question) {
    static const std::array all{&studyViewer(),   &comparisonViewer(), &scoreViewer(),   &pointsViewer(),
                                &byPlaceViewer(), &reviewViewer(),     &glazingViewer(), &savedViewer()};
    const auto found = std::ranges::find(all, question, &AnswerViewer::question);
    return found == all.end() ? anyViewer : **found;
}

namespace {

QString qtText(const std::string& text) { return QString::fromStdString(text); }

// In local time, since the reader usually saved it on the same machine.
QString keptAt(const SavedOrigin& origin) {
    const QDateTime at = QDateTime::fromString(qtText(origin.at), Qt::ISODate).toLocalTime();
    return at.isValid() ? at.toString(QStringLiteral("yyyy-MM-dd HH:mm")) : QObject::tr("at an unknown date");
}

QString noteOf(const SavedContent& result) {
    const QString saved =
        QObject::tr("Saved %1: %2").arg(keptAt(result.answer.origin), shownName(result.result));
    return result.upToDate() ? saved : QObject::tr("%1. Outdated").arg(saved);
}

// The note states when the result was saved and whether anything has changed since; if so, it is marked.
std::optional<AnswerLayer> layerOfSaved(const std::shared_ptr<const Answer>& answer) {
    const auto saved = contentOf<SavedContent>(answer);
    const auto find = viewerOf(saved->result->kind).savedLayer;
    auto layer = find ? find(saved) : std::nullopt;
    if (!layer) return layer;
    std::visit(
        [&](auto& shown) {
            shown.note = noteOf(*saved);
            shown.marked = !saved->upToDate();
        },
        *layer);
    return layer;
}

// Its figures, preceded by what it is, where, when and by which version it was computed.
std::vector<ResultRow> rowsOfSaved(const Answer& answer, ShownAs show) {
    const auto& saved = *answer.as<SavedContent>();
    const SavedOrigin& origin = saved.answer.origin;
    std::vector<ResultRow> rows{
        {QObject::tr("Saved result"), shownName(saved.result),
         QObject::tr("As saved in the project, not recomputed")},
        {QObject::tr("Scenario"), scenarioName(saved.result->scenario), {}},
        {QObject::tr("Region"),
         QObject::tr("%1\ncells of %2 m")
             .arg(origin.region.empty() ? QObject::tr("unnamed") : placeName(origin.region))
             .arg(saved.result->grid.cellM),
         {}},
        {QObject::tr("Computed by"),
         QObject::tr("%1, saved %2").arg(qtText(origin.program), keptAt(origin)),
         {}}};
    const auto list = viewerOf(saved.result->kind).savedRows;
    for (ResultRow& row : list ? list(saved, show) : figureRows(answer.figures()))
        rows.push_back(std::move(row));
    return rows;
}

QString titleOfSaved(const Answer& answer) {
    return QObject::tr("Saved result %1").arg(shownName(answer.as<SavedContent>()->result));
}

// When the result was saved, and each change since.
AnswerNote describeSaved(const Answer& answer) {
    const auto& saved = *answer.as<SavedContent>();
    QStringList words{QObject::tr("A result saved %1.").arg(keptAt(saved.answer.origin))};
    for (const auto* changes : {&saved.changes, &saved.weightChanges})
        for (const std::string& change : *changes) words << qtText(change);
    if (saved.upToDate()) words << QObject::tr("Its inputs have not changed since.");
    return {words.join(QLatin1Char('\n')), !saved.upToDate()};
}

}  // namespace

const AnswerViewer& savedViewer() {
    static const AnswerViewer viewer{.question = savedQuestion().key,
                                     .layer = layerOfSaved,
                                     .rows = rowsOfSaved,
                                     .savedTitle = titleOfSaved,
                                     .note = describeSaved};
    return viewer;
}

namespace {

// The review dock lists the places, or paints the windows; here stand the counts.
std::vector<ResultRow> rowsOfReview(const Answer& answer, ShownAs) { return figureRows(answer.figures()); }

template <class Reviewed>
std::string ruleOf(const Answer& answer) {
    return answer.as<Reviewed>()->question.rule.name;
}

}  // namespace

const AnswerViewer& reviewViewer() {
    static const AnswerViewer viewer{.question = reviewQuestion().key,
                                     .layer = nullptr,
                                     .rows = rowsOfReview,
                                     .rule = ruleOf<ReviewAnswer>};
    return viewer;
}

const AnswerViewer& glazingViewer() {
    static const AnswerViewer viewer{.question = glazingQuestion().key,
                                     .layer = nullptr,
                                     .rows = rowsOfReview,
                                     .rule = ruleOf<GlazingAnswer>};
    return viewer;
}

}  // namespace noonmark
