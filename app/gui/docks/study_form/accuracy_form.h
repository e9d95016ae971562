#pragma once

#include <QWidget>
#include <vector>

#include "core/study/study.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace noonmark {

/// Engine, and a field for each of its options, built from its EngineInfo.
class AccuracyForm final : public QWidget {
    Q_OBJECT
public:
    explicit AccuracyForm(const EngineList& engines = coreEngines(), QWidget* parent = nullptr);

    void show(const StudySettings& settings);                           ///< without a signal
    [[nodiscard]] StudySettings applied(StudySettings settings) const;  ///< with the fields' values

Q_SIGNALS:
    void edited(QString field);  ///< the name of the field

private:
    void fillEngines();
    void makeFields(const EngineInfo& engine);
    void chooseEngine();

    struct Field {
        EngineOption option;
        QWidget* widget;         // one of:
        QDoubleSpinBox* number;  // null for a switch
        QCheckBox* check;        // null for a number
    };
    void addField(const EngineOption& option);
    static void setValue(const Field& field, double value);
    const EngineList& engines_;
    QComboBox* engine_;
    QFormLayout* form_;
    int fixedRows_ = 0;  // the rows before the options
    std::string shown_;  // the engine whose options are shown
    std::vector<Field> fields_;
};

}  // namespace noonmark
