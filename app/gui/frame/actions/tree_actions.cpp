#include "app/gui/frame/actions/tree_actions.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QTimer>
#include <algorithm>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/session/workbench.h"

namespace noonmark {

namespace {

constexpr int editPauseMs = 400;  // between an edit and the reading that it causes
constexpr std::size_t maxWarningLines = 4;

const ListedLayer* firstLayer(const ListedTrees& listed) {
    return listed.layers.empty() ? nullptr : &listed.layers.front();
}

bool isRaster(const ListedTrees& listed) {
    return listed.content == TreeContent::raster || listed.content == TreeContent::canopy;
}

QString textOfKey(const TreeRoleEntry& role) {
    return QString::fromUtf8(role.key.data(), qsizetype(role.key.size()));
}

QString describeContent(const QString& file, const ListedTrees& listed) {
    const QString name = QFileInfo(file).fileName();
    if (listed.content == TreeContent::map)
        return QObject::tr("%1: OpenStreetMap, whose tags are known.").arg(name);
    if (isRaster(listed))
        return QObject::tr("%1: a raster. Its cells are taken for heights of the canopy above the ground.")
            .arg(name);
    const ListedLayer* layer = firstLayer(listed);
    const std::size_t features = layer == nullptr ? 0 : layer->features;
    return QObject::tr("%1: %2 feature(s) in layer %3.", "", pluralNumber(features))
        .arg(name, formatCount(features), layer == nullptr ? QString() : QString::fromStdString(layer->name));
}

QString countSources(std::span<const Tree> trees, TreeSource Tree::*source) {
    QStringList words;
    for (const auto& [one, name] : {std::pair(TreeSource::measured, QObject::tr("%1 measured")),
                                    std::pair(TreeSource::estimated, QObject::tr("%1 estimated")),
                                    std::pair(TreeSource::assumed, QObject::tr("%1 assumed"))})
        if (const auto count = std::ranges::count(trees, one, source); count > 0)
            words << name.arg(formatCount(std::size_t(count)));
    return words.join(QObject::tr(", "));
}

QString describeRange(std::span<const Tree> trees, float Tree::*measure) {
    const auto [low, high] = std::ranges::minmax(trees, {}, measure);
    return QObject::tr("%1 to %2")
        .arg(describeLength(double(low.*measure)), describeLength(double(high.*measure)));
}

}  // namespace

QString describeImport(const TreesImported& imported) {
    QString text = QObject::tr("%1 tree(s) are added.", "", pluralNumber(imported.added))
                       .arg(formatCount(imported.added));
    const auto& trees = imported.project.city->trees;
    if (imported.added > 0) {
        const std::size_t had = imported.before->trees ? imported.before->trees->trees.size() : 0;
        const std::span<const Tree> added = std::span(trees->trees).subspan(had);
        text +=
            u'\n' + QObject::tr("Heights: %1 (%2)")
                        .arg(describeRange(added, &Tree::heightM), countSources(added, &Tree::heightSource));
        text += u'\n' + QObject::tr("Crowns: %1 (%2)")
                            .arg(describeRange(added, &Tree::crownDiameterM),
                                 countSources(added, &Tree::crownSource));
    }
    const auto groups = groupWarnings(imported.warnings);
    for (std::size_t i = 0; i < std::min(maxWarningLines, groups.size()); ++i)
        text += u'\n' + describeWarningWithPlaces(groups[i], 1);
    if (groups.size() > maxWarningLines)
        text +=
            u'\n' + QObject::tr("%1 more kind(s) of notes", "", pluralNumber(groups.size() - maxWarningLines))
                        .arg(formatCount(groups.size() - maxWarningLines));
    return text;
}

TreeImportDialog::TreeImportDialog(QString file, ListedTrees listed, QWidget* parent)
    : QDialog(parent),
      file_(std::move(file)),
      listed_(std::move(listed)),
      crs_(new QLineEdit),
      outcome_(wrappedLabel("treeOutcome")),
      pause_(new QTimer(this)) {
    setObjectName(QStringLiteral("treeImport"));
    setWindowTitle(tr("Add trees"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* form = new QFormLayout(this);
    auto* content = wrappedLabel("treeContent");
    content->setText(describeContent(file_, listed_));
    form->addRow(content);
    for (const TreeRoleEntry& role : listTreeRoles()) addRow(*form, role);
    crs_->setObjectName(QStringLiteral("treeCrs"));
    crs_->setPlaceholderText(tr("as in the file (example: EPSG:2263)"));
    crs_->setToolTip(tr("Coordinate reference system, if the file does not state it"));
    form->addRow(tr("Coordinate system"), crs_);
    outcome_->setMinimumHeight((int(maxWarningLines) + 4) * outcome_->fontMetrics().lineSpacing());
    outcome_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    form->addRow(outcome_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    add_ = buttons->button(QDialogButtonBox::Ok);
    add_->setText(tr("Add"));
    add_->setObjectName(QStringLiteral("addTrees"));
    add_->setToolTip(tr("Adds the trees to the existing city; Undo takes them back"));
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    pause_->setSingleShot(true);
    pause_->setInterval(editPauseMs);
    connect(pause_, &QTimer::timeout, this, &TreeImportDialog::edited);
    connect(crs_, &QLineEdit::textEdited, this, &TreeImportDialog::readSoon);
}

// Of a raster only the unit of its heights can be chosen, of OpenStreetMap nothing.
void TreeImportDialog::addRow(QFormLayout& form, const TreeRoleEntry& role) {
    const bool cells = isRaster(listed_);
    if (cells ? role.role != TreeRole::height : firstLayer(listed_) == nullptr) return;
    const KnownTreeField* known = findRole(listed_.fields, role.role);
    Row row{&role, cells ? nullptr : makeFields(role), role.isLength ? makeUnits(role, known) : nullptr};
    if (row.field && row.unit) {
        form.addRow(translated(role.label), widgetRow({row.field, row.unit}, 1));
        const auto enable = [row] { row.unit->setEnabled(row.field->currentIndex() > 0); };
        connect(row.field, &QComboBox::currentIndexChanged, row.unit, enable);
        enable();
    } else {
        form.addRow(translated(role.label), row.field ? row.field : row.unit);
    }
    for (QComboBox* box : {row.field, row.unit})
        if (box) connect(box, &QComboBox::currentIndexChanged, this, &TreeImportDialog::readSoon);
    rows_.push_back(row);
}

QComboBox* TreeImportDialog::makeFields(const TreeRoleEntry& role) const {
    constexpr int shownLetters = 48;
    auto* fields = new QComboBox;
    fields->setObjectName(QStringLiteral("treeField-%1").arg(textOfKey(role)));
    fields->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    fields->setMinimumContentsLength(shownLetters);
    fields->addItem(tr("None"), QString());
    const ListedLayer& layer = *firstLayer(listed_);
    for (const ListedField& field : layer.fields) {
        const QString name = QString::fromStdString(field.name);
        fields->addItem(name + QStringLiteral("   ") +
                            localiseNumbers(QString::fromStdString(describeValues(field, layer.sampled))),
                        name);
        fields->setItemData(fields->count() - 1, fields->itemText(fields->count() - 1), Qt::ToolTipRole);
    }
    if (const KnownTreeField* known = findRole(listed_.fields, role.role))
        fields->setCurrentIndex(std::max(0, fields->findData(QString::fromStdString(known->field))));
    return fields;
}

QComboBox* TreeImportDialog::makeUnits(const TreeRoleEntry& role, const KnownTreeField* known) const {
    auto* units = new QComboBox;
    units->setObjectName(QStringLiteral("treeUnit-%1").arg(textOfKey(role)));
    if (known != nullptr && !known->meaning.classes.empty()) units->addItem(tr("classes"));
    for (const LengthUnitEntry& unit : listLengthUnits())
        units->addItem(QString::fromUtf8(unit.name.data(), qsizetype(unit.name.size())), int(unit.unit));
    units->setToolTip(tr("Unit of numbers without one"));
    const LengthUnit first = known == nullptr ? LengthUnit::metres : known->meaning.unit;
    const bool areClasses = units->itemData(0).isNull();
    if (!areClasses) units->setCurrentIndex(units->findData(int(first)));
    return units;
}

std::optional<TreeFieldChoice> TreeImportDialog::choiceOf(const Row& row) const {
    TreeFieldChoice choice{row.role->role, {}};
    if (row.field) choice.field = row.field->currentData().toString().toStdString();
    const QVariant unit = row.unit ? row.unit->currentData() : QVariant();
    if (!unit.isNull()) choice.unit = LengthUnit(unit.toInt());
    const KnownTreeField* known = findRole(listed_.fields, row.role->role);
    if (!row.field)
        return choice.unit == LengthUnit::metres ? std::nullopt : std::optional(std::move(choice));
    if (known == nullptr && choice.field.empty()) return std::nullopt;
    const bool isFound = known != nullptr && known->field == choice.field;
    const bool isUnitFound =
        !row.unit || (known != nullptr && (unit.isNull() ? !known->meaning.classes.empty()
                                                         : known->meaning.classes.empty() &&
                                                               known->meaning.unit == *choice.unit));
    if (isFound && isUnitFound) return std::nullopt;
    return choice;
}

TreeReading TreeImportDialog::reading() const {
    TreeReading how;
    if (const QString crs = crs_->text().trimmed(); !crs.isEmpty()) how.crs = crs.toStdString();
    for (const Row& row : rows_)
        if (auto choice = choiceOf(row)) how.fields.push_back(*std::move(choice));
    return how;
}

// What was read with other fields is not added.
void TreeImportDialog::readSoon() {
    showWaiting();
    pause_->start();
}

void TreeImportDialog::showWaiting() {
    shown_.reset();
    add_->setEnabled(false);
    outcome_->setText(tr("Reading the trees..."));
}

void TreeImportDialog::showOutcome(Result<TreesImported> outcome) {
    add_->setEnabled(outcome && outcome->added > 0);
    outcome_->setText(outcome ? describeImport(*outcome) : describeError(outcome.error()));
    if (outcome) shown_ = *std::move(outcome);
}

TreeActions::TreeActions(Workbench& workbench, MessageBar& messages, QWidget& window)
    : workbench_(workbench), messages_(messages), window_(window) {}

void TreeActions::askForFile() {
    const QString file =
        QFileDialog::getOpenFileName(&window_, tr("Add trees"), {},
                                     makeFileFilter(tr("Inventories of trees and canopy heights"),
                                                    endingsOf({FileKind::footprints, FileKind::terrain})) +
                                         QStringLiteral(";;") + tr("All files (*)"));
    if (!file.isEmpty()) ask(file);
}

void TreeActions::ask(const QString& file) {
    if (!workbench_.city()) return messages_.showError(noCityError());
    reading_.start<ListedTrees>(
        tr("Listing fields"),
        [file = file.toStdString()](Progress&, const std::stop_token& stop) { return listTrees(file, stop); },
        [this, file](Result<ListedTrees> listed) {
            if (listed && listed->content != TreeContent::none) return show(file, *std::move(listed));
            if (listed)
                return messages_.showError({"It holds no trees", file.toStdString(),
                                            "Give points, a table with columns of longitude and latitude, or "
                                            "a raster of canopy heights"});
            if (!isCancelled(listed.error())) messages_.showError(listed.error());
        });
}

void TreeActions::show(const QString& file, ListedTrees listed) {
    auto* dialog = new TreeImportDialog(file, std::move(listed), &window_);
    connect(dialog, &TreeImportDialog::edited, this, [this, dialog] { read(*dialog); });
    connect(dialog, &QDialog::accepted, this, [this, dialog] { take(dialog->takeOutcome()); });
    connect(dialog, &QDialog::rejected, &reading_, &JobSlot::drop);
    dialog->show();
    read(*dialog);
}

void TreeActions::read(TreeImportDialog& dialog) {
    dialog.showWaiting();
    reading_.start<TreesImported>(
        tr("Reading trees"),
        [project = workbench_.session().project(), file = dialog.file().toStdString(),
         how = dialog.reading()](Progress& progress, const std::stop_token& stop) {
            return importTrees(project, {file}, how, progress, stop);
        },
        [shown = QPointer<TreeImportDialog>(&dialog)](Result<TreesImported> outcome) {
            if (shown) shown->showOutcome(std::move(outcome));
        });
}

// The project may have changed while the dialog was open, but for its city.
void TreeActions::take(TreesImported imported) {
    Project next = workbench_.session().project();
    if (next.city != imported.before)
        return messages_.showError({"The city has changed meanwhile", {}, "Add the trees again"});
    next.city = imported.project.city;
    next.reading = imported.project.reading;
    next.inputs = imported.project.inputs;
    if (workbench_.session().change(std::move(next), tr("add trees")))
        messages_.showNote(describeImport(imported));
}

}  // namespace noonmark
