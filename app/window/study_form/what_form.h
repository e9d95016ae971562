#pragma once

#include <QWidget>

#include "core/receivers/receivers.h"

class QComboBox;
class QLabel;

namespace noonmark {

/// What a study finds out.
enum class StudyKind {
    shadow,  ///< minutes of shadow of the displayed scenario
    change,  ///< how a scenario changes the shadow
    score,   ///< good and bad shadow, weighed by hours and months
    review,  ///< verdicts by a rule of a review board
};

/// What: the kind of study, and the surfaces where it measures.
class WhatForm final : public QWidget {
    Q_OBJECT
public:
    explicit WhatForm(QWidget* parent = nullptr);

    void show(StudyKind kind, ReceiverPlaces places);  ///< without a signal
    [[nodiscard]] StudyKind kind() const;

Q_SIGNALS:
    void kindChosen(noonmark::StudyKind kind);
    void placesChosen(noonmark::ReceiverPlaces places);

private:
    void fill();
    void explain();

    QComboBox* kind_;
    QComboBox* places_;
    QLabel* about_;  ///< one line on the kind
};

}  // namespace noonmark
