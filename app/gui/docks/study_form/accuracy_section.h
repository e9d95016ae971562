#pragma once

#include <QWidget>

#include "core/study/study.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace noonmark {

class AccuracyForm;
class FoldedSection;

/// Accuracy: the size of a cell and a plain choice of how exactly to compute; method and options fold away.
class AccuracySection final : public QWidget {
    Q_OBJECT
public:
    explicit AccuracySection(QWidget* parent = nullptr);

    void show(const StudySettings& settings);  ///< without a signal
    void setTerrain(bool terrain);             ///< the city has terrain, which not every engine supports

Q_SIGNALS:
    void edited(noonmark::StudySettings settings, QString field);  ///< the name of the field
    void paperRequested();  ///< exploration and analysis as in the paper

private:
    void makeFields();
    void connectFields();
    void showChoice();

    StudySettings settings_;
    bool terrain_ = false;
    QDoubleSpinBox* cell_;
    QComboBox* choice_;
    QLabel* about_;
    AccuracyForm* form_;
    FoldedSection* method_;
};

}  // namespace noonmark
