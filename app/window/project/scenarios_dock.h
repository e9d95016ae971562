#pragma once

#include <QWidget>

namespace noonmark {

class ProjectSession;
class ScenarioTable;

/// All scenarios and their figures side by side, and the button that works out those that are missing.
class ScenariosDock final : public QWidget {
    Q_OBJECT
public:
    explicit ScenariosDock(ProjectSession& session, QWidget* parent = nullptr);  ///< `session` outlives it

    [[nodiscard]] ScenarioTable& table() { return *table_; }

Q_SIGNALS:
    void measureAllRequested();

private:
    ScenarioTable* table_;
};

}  // namespace noonmark
