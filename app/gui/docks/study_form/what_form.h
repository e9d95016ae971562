#pragma once

#include <QWidget>
#include <array>
#include <string_view>

#include "core/receivers/receivers.h"
#include "core/study/elements/place_elements.h"
#include "core/study/study.h"

class QCheckBox;
class QLabel;
class QComboBox;

namespace noonmark {

/// What a study of cells also finds out: the shadow of each month, and what each building takes. What the
/// engine cannot do is disabled, and a line says which engines can.
class BreakdownForm final : public QWidget {
    Q_OBJECT
public:
    explicit BreakdownForm(QWidget* parent = nullptr);

    void show(const StudySettings& settings);  ///< without a signal
    void setOfCells(bool ofCells);             ///< false: points or a comparison, which have neither

Q_SIGNALS:
    void edited(noonmark::StudySettings settings, QString field);  ///< the name of the field

private:
    void enable();

    StudySettings settings_;
    bool ofCells_ = true;
    QCheckBox* months_;
    QCheckBox* contributions_;
    QLabel* why_;  ///< why a box is disabled
};

/// Why the settings' engine does not sum by months, or by buildings, and which engines do; empty: it does.
QString whyNoMonths(const StudySettings& settings);
QString whyNoContributions(const StudySettings& settings);

class ElementForm;

/// What a study finds out.
enum class StudyKind {
    shadow,  ///< minutes of shadow of the displayed scenario
    change,  ///< how a scenario changes the shadow
    score,   ///< good and bad shadow, weighed by hours and months
    review,  ///< verdicts by a rule of a review board
    places,  ///< hours of sun of parks, streets and other places
};
/// Their keys in project files.
inline constexpr std::array<std::string_view, 5> studyKindKeys{"shadow", "change", "score", "review",
                                                               "places"};

/// What: the kind of study, and the surfaces where it measures.
class WhatForm final : public QWidget {
    Q_OBJECT
public:
    explicit WhatForm(QWidget* parent = nullptr);

    /// Without a signal. `elements`: points are measured instead of cells.
    void show(StudyKind kind, ReceiverPlaces places, const std::optional<ElementSettings>& elements);
    void setBuilding(const QString& id);  ///< the selected building; empty: none
    [[nodiscard]] StudyKind kind() const;
    [[nodiscard]] ElementForm& elements() { return *elements_; }

Q_SIGNALS:
    void kindChosen(noonmark::StudyKind kind);
    void placesChosen(noonmark::ReceiverPlaces places);                      ///< cells
    void elementsChosen(noonmark::ElementSettings elements, QString field);  ///< points

private:
    void fill();
    void choosePlaces(int chosen);
    void explain();

    QComboBox* kind_;
    QComboBox* places_;  ///< the places of cells, then those of points
    ElementForm* elements_;
    QLabel* about_;  ///< one line on the kind
};

}  // namespace noonmark
