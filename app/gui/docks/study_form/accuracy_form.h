#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "core/study/study.h"

class QComboBox;
class QFormLayout;

namespace noonmark {

class FieldRows;

/// Engine, and a row for each of its options.
class AccuracyForm final : public QWidget {
    Q_OBJECT
public:
    explicit AccuracyForm(const EngineList& engines = coreEngines(), QWidget* parent = nullptr);
    ~AccuracyForm() override;

    void show(const StudySettings& settings);                           ///< without a signal
    [[nodiscard]] StudySettings applied(StudySettings settings) const;  ///< with the fields' values

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

}  // namespace noonmark
