#pragma once

#include <QString>
#include <QWidget>
#include <array>
#include <memory>
#include <vector>

#include "core/lab/lab_engines.h"
#include "core/study/study.h"

class QComboBox;
class QFormLayout;
class QDoubleSpinBox;
class QLabel;

namespace noonmark {

/// How exactly a study is computed, without the names of engines.
enum class AccuracyChoice {
    quick,      ///< the automatic engine: exact where that is as quick
    exact,      ///< projected shadows, or rays on terrain and roofs
    reference,  ///< the ray reference
    own,        ///< an engine or options of the user's
};

/// In the order of the list; `own` is the last.
inline constexpr std::array allAccuracyChoices{AccuracyChoice::quick, AccuracyChoice::exact,
                                               AccuracyChoice::reference, AccuracyChoice::own};

QString nameOf(AccuracyChoice choice);    ///< "Quick"
QString describe(AccuracyChoice choice);  ///< one line

/// The settings with the engine of the choice and its default options; `own` changes nothing. `terrain`: the
/// city has terrain.
StudySettings withAccuracy(AccuracyChoice choice, StudySettings settings, bool terrain);

/// The choice that these settings are. Rays on terrain are the reference.
AccuracyChoice choiceOf(const StudySettings& settings, bool terrain);

/// The settings for analysis as in the paper: inverse accrual maps through the direction graph.
StudySettings asInPaper(StudySettings settings);
bool isAsInPaper(const StudySettings& settings);

class FieldRows;

/// Engine, and a row for each of its options.
class AccuracyForm final : public QWidget {
    Q_OBJECT
public:
    explicit AccuracyForm(const EngineList& engines = coreAndLabEngines(), QWidget* parent = nullptr);
    ~AccuracyForm() override;

    void show(const StudySettings& settings);                              ///< without a signal
    [[nodiscard]] StudySettings withFields(StudySettings settings) const;  ///< with the fields' values

Q_SIGNALS:
    void edited(QString field);  ///< the name of the field

private:
    void fillEngines();
    void makeFields(const EngineInfo& engine);
    void chooseEngine();

    const EngineList& engines_;
    QComboBox* engine_;
    QFormLayout* form_;
    int fixedRows_ = 0;  // the rows before the options
    std::string shown_;  // the engine whose options are shown
    std::vector<Field> options_;
    std::unique_ptr<FieldRows> rows_;  // of the options
};

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
