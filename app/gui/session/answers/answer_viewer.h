#pragma once

#include <variant>

#include "app/gui/base/layers/field_picture.h"
#include "app/gui/base/layers/ground_answer.h"
#include "app/gui/session/answers/measured_answers.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/questions/saved_question.h"

namespace noonmark {

/// What the view shows of an answer: cells of the ground and of roofs, or points.
using AnswerLayer = std::variant<GroundAnswer, ElementView>;

/// A text above the figures of an answer.
struct AnswerNote {
    QString text;
    bool warns = false;  ///< in amber, and the figures are greyed out
};

/// How the window shows the answers to a question. A row of a list; questions that are not in it are shown by
/// Answer::figures() and field().
struct AnswerViewer {
    std::string_view question;  ///< its key; empty: any
    /// None: nothing in the view. Null: the view shows the answer behind it (Workbench::behind).
    std::optional<AnswerLayer> (*layer)(const std::shared_ptr<const Answer>&);
    std::vector<ResultRow> (*rows)(const Answer&, ShownAs);
    /// "%1 compared with %2", with the names of scenarios as the project has them. Null: "Glazing of %1".
    Sentence (*title)(const MeasuredPart&) = nullptr;
    /// Of a review: the name of its rule, with which its title begins.
    std::string (*rule)(const Answer&) = nullptr;
    QString (*savedTitle)(const Answer&) = nullptr;  ///< of results read back: instead of the title
    /// The name that it is saved under, with its first day; null: the title.
    Sentence (*name)(const MeasuredPart&) = nullptr;
    AnswerNote (*note)(const Answer&) = nullptr;  ///< null: none
    /// For saved results, whose note is added: what the view shows, and the rows after those on their origin;
    /// null: none, and Answer::figures().
    std::optional<AnswerLayer> (*savedLayer)(const std::shared_ptr<const SavedContent>&) = nullptr;
    std::vector<ResultRow> (*savedRows)(const SavedContent&, ShownAs) = nullptr;
};

/// The places of an answer about them, new or saved; null: it is about something else.
std::shared_ptr<const SunOfCities> sunOf(const std::shared_ptr<const Answer>& answer);

QString titleOf(const Answer& answer);

/// As lists name an answer: "Study of Tower, 2026-06-21".
QString listedName(const Answer& answer);

// Names that answers are kept under are English in the project file, and shown in the language of the window
// as long as the user gives no other.

/// The name of listedName(), and that under which "Save result" keeps an answer.
std::string storedName(const Answer& answer);
std::string nameToSave(const Answer& answer);
QString shownName(const MeasuredAnswer& measured);
/// The second remembers what it read of the result; for the window's thread.
QString shownName(const SavedResult& result);
QString shownName(const std::shared_ptr<const SavedResult>& result);

/// The row of the question with this key, or that of all others.
const AnswerViewer& viewerOf(std::string_view question);

/// The row of the answer's question, or that of all others.
const AnswerViewer& viewerOf(const Answer& answer);

const AnswerViewer& studyViewer();
const AnswerViewer& comparisonViewer();
const AnswerViewer& scoreViewer();
const AnswerViewer& pointsViewer();
const AnswerViewer& byPlaceViewer();
const AnswerViewer& reviewViewer();
const AnswerViewer& glazingViewer();
const AnswerViewer& savedViewer();

}  // namespace noonmark
