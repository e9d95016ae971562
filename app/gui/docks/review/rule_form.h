#pragma once

#include <QWidget>

#include "app/gui/docks/review/review_choice.h"
#include "core/review/library/rule_library.h"

class QComboBox;
class QFormLayout;

namespace noonmark {

/// The rule with its choices, the baseline and the scenario.
class RuleForm final : public QWidget {
    Q_OBJECT
public:
    explicit RuleForm(const RuleLibrary& library, QWidget* parent = nullptr);

    /// `displayed`: the scenario that the window shows.
    void show(const ReviewChoice& choice, const std::vector<Scenario>& scenarios,
              const std::string& displayed);
    /// Time zone of the site: the rules of its country come first.
    void setZone(const std::string& zone);

Q_SIGNALS:
    void edited(noonmark::ReviewChoice choice);  ///< rule, options, baseline or scenario differ

private:
    void listRules();
    void addHeading(const RuleGroup& group);
    void showOptions(const Rule& rule);
    void showScenarios(const std::vector<Scenario>& scenarios, const std::string& displayed);
    QComboBox* makeList(const char* name);
    void take();

    const RuleLibrary& library_;
    ReviewChoice choice_;
    QComboBox* rule_;
    QComboBox* from_;
    QComboBox* to_;
    QFormLayout* form_;
    QFormLayout* options_;
    std::string zone_;
    std::string optionsOf_;  ///< the rule whose choices are shown
    std::map<std::string, QComboBox*> lists_;
};

}  // namespace noonmark
