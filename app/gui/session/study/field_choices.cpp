#include "app/gui/session/study/field_choices.h"

#include <QAbstractItemView>
#include <QAction>
#include <QCompleter>
#include <QLineEdit>
#include <QStandardItemModel>
#include <QStyle>
#include <algorithm>

#include "app/gui/base/widgets/number_words.h"

namespace noonmark {

namespace {

constexpr int nameRole = Qt::UserRole;
constexpr int listWidth = 460;

QString fieldText(const std::string& utf8) { return QString::fromStdString(utf8); }

// Only layers that are read; all where none is.
std::vector<const ListedLayer*> readLayers(const std::vector<FieldsOfFile>& files) {
    std::vector<const ListedLayer*> layers;
    for (const FieldsOfFile& file : files)
        for (const ListedLayer& layer : file.layers)
            if (layer.isRead) layers.push_back(&layer);
    return layers;
}

QString describeField(const ListedField& field, std::size_t sampled) {
    const QString alias =
        field.alias.empty() ? QString() : QStringLiteral(" (%1)").arg(fieldText(field.alias));
    return fieldText(field.name) + alias + QStringLiteral("   ") +
           localiseNumbers(fieldText(describeValues(field, sampled)));
}

// Numbers come first where numbers are wanted; a field that is read for another purpose stays choosable.
bool isLikely(const ListedField& field, FieldRole role) {
    return role == FieldRole::name ? !field.low.has_value() : field.low.has_value();
}

using Entries = std::vector<std::pair<QString, QString>>;

Entries listEntries(const std::vector<const ListedLayer*>& layers, FieldRole role) {
    Entries likely, others;
    for (const ListedLayer* layer : layers)
        for (const ListedField& field : layer->fields) {
            Entries& list = isLikely(field, role) ? likely : others;
            list.emplace_back(fieldText(field.name), describeField(field, layer->sampled));
        }
    likely.insert(likely.end(), others.begin(), others.end());
    return likely;
}

QString findByName(const std::vector<const ListedLayer*>& layers, FieldRole role) {
    for (const ListedLayer* layer : layers) {
        const auto found = std::ranges::find(layer->fields, std::optional(role), &ListedField::role);
        if (found != layer->fields.end()) return fieldText(found->name);
    }
    return {};
}

}  // namespace

FieldChoices::FieldChoices(QWidget& form) : QObject(&form) {
    const auto line = [&form](const char* name) {
        return form.findChild<QLineEdit*>(QString::fromLatin1(name));
    };
    fields_ = {{line("heightField"), FieldRole::height},
               {line("levelsField"), FieldRole::levels},
               {line("buildingNameField"), FieldRole::name}};
    layer_ = line("layer");
}

void FieldChoices::show(const std::vector<FieldsOfFile>& files) {
    const auto layers = readLayers(files);
    for (const Choosable& field : fields_) {
        if (!field.line) continue;
        addList(*field.line, listEntries(layers, field.role));
        const QString found = findByName(layers, field.role);
        field.line->setPlaceholderText(found.isEmpty() ? tr("none is found by name")
                                                       : tr("found by name: %1").arg(found));
    }
    Entries names;
    for (const FieldsOfFile& file : files)
        for (const ListedLayer& layer : file.layers)
            names.emplace_back(fieldText(layer.name),
                               tr("%1   %2 feature(s)", "", pluralNumber(layer.features))
                                   .arg(fieldText(layer.name), formatCount(layer.features)));
    if (layer_) addList(*layer_, names);
}

// The arrow at the end of the line, and the key Down, open the list.
void FieldChoices::addList(QLineEdit& line, const Entries& entries) {
    auto* model = new QStandardItemModel;
    for (const auto& [name, shown] : entries) {
        auto* item = new QStandardItem(shown);
        item->setData(name, nameRole);
        item->setToolTip(shown);
        model->appendRow(item);
    }
    auto* list = new QCompleter(model, &line);
    model->setParent(list);
    list->setCompletionRole(nameRole);
    list->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
    list->popup()->setMinimumWidth(listWidth);
    connect(list, qOverload<const QString&>(&QCompleter::activated), this, &FieldChoices::chosen,
            Qt::QueuedConnection);  // after the line has taken the name
    delete line.completer();
    line.setCompleter(list);
    if (auto* arrow = line.findChild<QAction*>(QStringLiteral("openList"))) delete arrow;
    if (entries.empty()) return;
    QAction* arrow =
        line.addAction(line.style()->standardIcon(QStyle::SP_ArrowDown), QLineEdit::TrailingPosition);
    arrow->setObjectName(QStringLiteral("openList"));
    arrow->setToolTip(tr("Lists the fields with sample values"));
    connect(arrow, &QAction::triggered, list, [list, &line] {
        line.setFocus();  // only a line with the keys takes what is chosen
        list->complete();
    });
}

}  // namespace noonmark
