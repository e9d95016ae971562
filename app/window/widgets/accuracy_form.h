#pragma once

#include <QWidget>
#include <vector>

#include "core/study/study.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace noonmark {

/// How large the cells are, which engine, and a field for each of its options: made from what the engines say
/// of themselves.
class AccuracyForm final : public QWidget {
    Q_OBJECT
public:
    explicit AccuracyForm(const EngineList& engines = coreEngines(), QWidget* parent = nullptr);

    void show(const StudySettings& settings);                           ///< without a signal
    [[nodiscard]] StudySettings applied(StudySettings settings) const;  ///< with the fields' values

Q_SIGNALS:
    void edited(QString field);  ///< what was changed, in words

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
    QDoubleSpinBox* cell_;
    QComboBox* engine_;
    QFormLayout* form_;
    int fixedRows_ = 0;  // those of the options follow
    std::string shown_;  // the engine that has the fields
    std::vector<Field> fields_;
};

}  // namespace noonmark
