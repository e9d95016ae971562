#pragma once

#include <QWidget>

#include "core/study/study.h"

class QCheckBox;
class QLabel;

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

}  // namespace noonmark
