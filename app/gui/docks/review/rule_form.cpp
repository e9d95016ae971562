#include "app/gui/docks/review/rule_form.h"

#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QStandardItemModel>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/docks/review/verdict_table.h"
#include "core/review/rule/rule_names.h"
#include "core/sun/zone_country.h"

namespace noonmark {

namespace {

QString qtText(std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); }

QString tipOf(const Rule& rule) {
    return QStringLiteral("<p><b>%1</b></p><p>%2</p><p>%3</p><p>%4</p>")
        .arg(ruleName(rule.where).toHtmlEscaped(), ruleName(rule.summary).toHtmlEscaped(),
             describeStatus(rule).toHtmlEscaped(), qtText(rule.source).toHtmlEscaped());
}

}  // namespace

RuleForm::RuleForm(const RuleLibrary& library, QWidget* parent)
    : QWidget(parent), library_(library), form_(new QFormLayout(this)), options_(new QFormLayout) {
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    rule_ = makeList("reviewRule");
    from_ = makeList("reviewFrom");
    to_ = makeList("reviewTo");
    form_->addRow(tr("Rule"), rule_);
    form_->addRow(options_);
    form_->addRow(tr("Baseline"), from_);
    form_->addRow(tr("Scenario"), to_);
    listRules();
}

QComboBox* RuleForm::makeList(const char* name) {
    auto* list = new QComboBox;
    list->setObjectName(QString::fromLatin1(name));
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(14);
    connect(list, &QComboBox::activated, this, &RuleForm::take);
    return list;
}

void RuleForm::listRules() {
    rule_->clear();
    for (const RuleGroup& group : groupByCountry(library_.rules(), countryOfZone(zone_))) {
        addHeading(group);
        for (const Rule* rule : group.rules) {
            rule_->addItem(ruleName(rule->name), qtText(rule->key));
            rule_->setItemData(rule_->count() - 1, tipOf(*rule), Qt::ToolTipRole);
        }
    }
}

/// A line of the list that cannot be chosen.
void RuleForm::addHeading(const RuleGroup& group) {
    const QString name = ruleName(group.name);
    rule_->addItem(group.isAbroad ? tr("%1 (not where the site is)").arg(name) : name);
    auto* model = qobject_cast<QStandardItemModel*>(rule_->model());
    model->item(rule_->count() - 1)->setFlags(Qt::NoItemFlags);
}

void RuleForm::setZone(const std::string& zone) {
    if (zone_ == zone) return;
    zone_ = zone;
    const QVariant shown = rule_->currentData();
    listRules();
    rule_->setCurrentIndex(rule_->findData(shown));
}

void RuleForm::show(const ReviewChoice& choice, const std::vector<Scenario>& scenarios,
                    const std::string& displayed) {
    choice_ = choice;
    rule_->setCurrentIndex(rule_->findData(qtText(choice.rule)));
    const auto rule = library_.find(choice.rule, choice.options);
    rule_->setToolTip(rule ? tipOf(*rule) : QString());
    showScenarios(scenarios, displayed);
    if (!rule) return;
    showOptions(*rule);
    from_->setToolTip(tr("What the proposal is compared with. The rule asks for: %1")
                          .arg(translated(ruleNameOf(baselineNames(), rule->baseline.kind))));
}

void RuleForm::showScenarios(const std::vector<Scenario>& scenarios, const std::string& displayed) {
    from_->clear();
    to_->clear();
    to_->addItem(tr("Displayed: %1").arg(scenarioName(displayed)), QString());
    from_->addItem(scenarioName(existingCity), qtText(existingCity));
    for (const Scenario& scenario : scenarios)
        for (QComboBox* list : {from_, to_}) list->addItem(qtText(scenario.name), qtText(scenario.name));
    from_->setCurrentIndex(from_->findData(qtText(choice_.from)));
    to_->setCurrentIndex(to_->findData(qtText(choice_.to)));
}

void RuleForm::showOptions(const Rule& rule) {
    if (optionsOf_ != rule.key) {
        while (options_->rowCount() > 0) options_->removeRow(0);
        lists_.clear();
        for (const auto& [choice, options] : rule.choices) {
            QComboBox* list = makeList("reviewOption");
            for (const std::string& option : options) list->addItem(ruleName(option), qtText(option));
            QString title = ruleName(choice);
            title[0] = title[0].toUpper();
            options_->addRow(title, list);
            lists_[choice] = list;
        }
        optionsOf_ = rule.key;
    }
    for (const auto& [choice, list] : lists_)
        if (const auto chosen = rule.chosen.find(choice); chosen != rule.chosen.end())
            list->setCurrentIndex(list->findData(qtText(chosen->second)));
}

void RuleForm::take() {
    ReviewChoice choice = choice_;
    const std::string rule = rule_->currentData().toString().toStdString();
    if (rule != choice.rule) choice.options.clear();
    choice.rule = rule;
    if (rule == optionsOf_)
        for (const auto& [name, list] : lists_)
            choice.options[name] = list->currentData().toString().toStdString();
    choice.from = from_->currentData().toString().toStdString();
    choice.to = to_->currentData().toString().toStdString();
    Q_EMIT edited(choice);
}

}  // namespace noonmark
