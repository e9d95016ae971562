#include "app/gui/docks/project/project_dock.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/docks/project/project_model.h"
#include "app/gui/session/project/project_session.h"
#include "app/gui/session/study/region_text.h"

namespace noonmark {

namespace {

QString wordOf(ParcelSide side) {
    switch (side) {
        case ParcelSide::north:
            return LotRoadsDialog::tr("North");
        case ParcelSide::northeast:
            return LotRoadsDialog::tr("Northeast");
        case ParcelSide::east:
            return LotRoadsDialog::tr("East");
        case ParcelSide::southeast:
            return LotRoadsDialog::tr("Southeast");
        case ParcelSide::south:
            return LotRoadsDialog::tr("South");
        case ParcelSide::southwest:
            return LotRoadsDialog::tr("Southwest");
        case ParcelSide::west:
            return LotRoadsDialog::tr("West");
        case ParcelSide::northwest:
            return LotRoadsDialog::tr("Northwest");
    }
    return {};
}

/// Row and column around the lot, which is at 1, 1.
std::pair<int, int> cellOf(ParcelSide side) {
    constexpr std::array<std::pair<int, int>, 8> cells{
        {{0, 1}, {0, 2}, {1, 2}, {2, 2}, {2, 1}, {2, 0}, {1, 0}, {0, 0}}};
    return cells[std::size_t(side)];
}

QDoubleSpinBox* widthField(ParcelSide side, const std::vector<RoadFront>& roads) {
    QDoubleSpinBox* field = lengthField(0, maxRoadM, 2, 0.5);
    field->setObjectName(QString::fromUtf8(nameOf(side).data(), qsizetype(nameOf(side).size())));
    field->setSpecialValueText(LotRoadsDialog::tr("no road"));
    const auto road = std::ranges::find(roads, side, &RoadFront::side);
    field->setValue(road == roads.end() ? 0 : road->widthM);
    return field;
}

}  // namespace

LotRoadsDialog::LotRoadsDialog(const QString& lot, const std::vector<RoadFront>& roads, QWidget* parent)
    : QDialog(parent), before_(roads) {
    setWindowTitle(tr("Roads along %1").arg(lot));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* grid = new QGridLayout(this);
    auto* words = new QLabel(
        tr("How wide are the roads, water or railways on each side? Rules about parcels, as in Japan, move "
           "the parcel's line out along them. A side counts for the outermost edges that face within 45 "
           "degrees of it."));
    words->setWordWrap(true);
    grid->addWidget(words, 0, 0, 1, 3);
    for (const ParcelSide side : parcelSides) {
        const auto [row, column] = cellOf(side);
        widths_[side] = widthField(side, roads);
        auto* label = new QLabel(wordOf(side));
        label->setBuddy(widths_[side]);
        grid->addWidget(label, 1 + 2 * row, column, Qt::AlignCenter);
        grid->addWidget(widths_[side], 2 + 2 * row, column);
    }
    grid->addWidget(new QLabel(lot), 3, 1, 2, 1, Qt::AlignCenter);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    grid->addWidget(buttons, 7, 0, 1, 3);
}

std::vector<RoadFront> LotRoadsDialog::roads() const {
    std::vector<RoadFront> roads;
    for (const auto& [side, field] : widths_) {
        if (field->value() <= 0) continue;
        const auto before = std::ranges::find(before_, side, &RoadFront::side);
        // A field rounds to centimetres: a width that was not touched stays as it is.
        const bool same = before != before_.end() && std::abs(before->widthM - field->value()) < 0.0051;
        roads.push_back({side, same ? before->widthM : field->value()});
    }
    return roads;
}

namespace {

using Kind = ProjectNode::Kind;

bool canRemove(const ProjectNode& node) {
    return node.kind == Kind::edit || (node.kind == Kind::part && node.name != existingCity);
}

bool canDuplicate(const ProjectNode& node) {
    return canRemove(node) && node.kind == Kind::part && node.part != ProjectPart::result;
}

QString describeUse(ProjectPart part) {
    switch (part) {
        case ProjectPart::scenario:
            return QObject::tr("&Show");
        case ProjectPart::lot:
            return QObject::tr("&Zoom to lot");
        case ProjectPart::place:
            return QObject::tr("&Zoom to place");
        case ProjectPart::region:
            return QObject::tr("&Use as study region");
        case ProjectPart::period:
            return QObject::tr("&Use as study period");
        case ProjectPart::view:
            return QObject::tr("&Go to this view");
        case ProjectPart::weights:
            return QObject::tr("&Edit and score");
        case ProjectPart::result:
            return QObject::tr("&Show");
    }
    return {};
}

}  // namespace

ProjectDock::ProjectDock(ProjectSession& session, QWidget* parent)
    : QWidget(parent), session_(session), model_(new ProjectModel(session, this)), tree_(new QTreeView) {
    tree_->setObjectName(QStringLiteral("projectTree"));
    tree_->setModel(model_);
    tree_->setHeaderHidden(true);
    tree_->setUniformRowHeights(true);
    tree_->setTextElideMode(Qt::ElideMiddle);
    tree_->setExpandsOnDoubleClick(false);
    tree_->setEditTriggers(QAbstractItemView::EditKeyPressed);
    tree_->setContextMenuPolicy(Qt::CustomContextMenu);
    tree_->installEventFilter(this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(tree_);
    connect(tree_, &QTreeView::doubleClicked, this, &ProjectDock::use);
    connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& index) {
                const ProjectNode* node = model_->nodeAt(index);
                const bool place =
                    node != nullptr && node->kind == Kind::part && node->part == ProjectPart::place;
                Q_EMIT placeSelected(place ? node->name : std::string());
            });
    connect(model_, &ProjectModel::renamed, this, &ProjectDock::select);  // its row is another one now
    connect(tree_, &QWidget::customContextMenuRequested, this, &ProjectDock::showMenu);
    connect(model_, &QAbstractItemModel::rowsInserted, this, [this](const QModelIndex& group) {
        if (group.isValid() && !group.parent().isValid()) openGroup(group);
    });
    for (int i = 0; i < model_->rowCount(); ++i) openGroup(model_->index(i, 0));
}

// Expands the groups that are used most; lots, places (a map has hundreds) and weight tables stay collapsed.
void ProjectDock::openGroup(const QModelIndex& group) {
    const auto part = model_->nodeAt(group)->part;
    const bool folded =
        part == ProjectPart::lot || part == ProjectPart::place || part == ProjectPart::weights;
    if (part && !folded) tree_->expand(group);
}

// The tree's keys take precedence over the window's shortcuts: Delete in the tree must not demolish the
// building selected in the view.
bool ProjectDock::eventFilter(QObject* watched, QEvent* event) {
    const bool claim = event->type() == QEvent::ShortcutOverride;
    if (watched != tree_ || (!claim && event->type() != QEvent::KeyPress))
        return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool enter = key == Qt::Key_Return || key == Qt::Key_Enter;
    const QWidget* focus = QApplication::focusWidget();
    const bool isNaming = focus != tree_ && tree_->isAncestorOf(focus);  // Enter ends the name
    if (isNaming || (!enter && key != Qt::Key_Delete)) return QWidget::eventFilter(watched, event);
    if (claim)
        event->accept();
    else if (enter)
        use(tree_->currentIndex());
    else
        remove(tree_->currentIndex());
    return true;
}

void ProjectDock::use(const QModelIndex& index) {
    const ProjectNode* node = model_->nodeAt(index);
    if (node == nullptr || !node->part || node->kind == Kind::group)
        return tree_->setExpanded(index, !tree_->isExpanded(index));
    const Project& project = session_.project();
    const std::string name = node->name;  // the action may remove the node
    if (node->part == ProjectPart::scenario) return session_.goTo(name);
    if (node->part == ProjectPart::result) return Q_EMIT resultChosen(name);
    if (node->part == ProjectPart::weights) return Q_EMIT weightsChosen(name);
    if (node->part == ProjectPart::place) return Q_EMIT placeChosen(name);
    if (node->part == ProjectPart::view) return Q_EMIT viewChosen(name);
    if (node->part == ProjectPart::region)
        if (const auto region = findRegion(project, name)) return Q_EMIT regionChosen(*region);
    if (node->part == ProjectPart::lot)
        if (const auto lot = findLot(project, name)) return Q_EMIT lotChosen(*lot);
    if (node->part == ProjectPart::period)
        for (const NamedPeriod& period : project.periods)
            if (period.name == name) return Q_EMIT periodChosen(period.period);
}

void ProjectDock::remove(const QModelIndex& index) {
    const ProjectNode* node = model_->nodeAt(index);
    if (node == nullptr || !canRemove(*node)) return;
    const std::string name = node->name;
    const QString shown = QString::fromStdString(name);
    if (node->kind == Kind::edit) {
        session_.change(withoutEdit(session_.project(), name, node->position),
                        tr("remove step %1 of %2").arg(node->position + 1).arg(shown));
        return;
    }
    const auto next = without(session_.project(), *node->part, name);
    if (!next) return Q_EMIT session_.refused(next.error());
    session_.change(*next, tr("delete %1").arg(shown));
}

void ProjectDock::duplicate(const QModelIndex& index) {
    const ProjectNode* node = model_->nodeAt(index);
    if (node == nullptr || !canDuplicate(*node)) return;
    const ProjectPart part = *node->part;
    std::string made;
    Project next = noonmark::duplicate(session_.project(), part, node->name, made);
    const QString what = tr("duplicate %1").arg(QString::fromStdString(node->name));
    if (session_.change(std::move(next), what, part == ProjectPart::scenario ? made : std::string()))
        select(part, made);
}

void ProjectDock::addScenario(const std::string& base) {
    const std::string name = nextProposal(session_.project().scenarios);
    if (session_.change(withScenario(session_.project(), name, base),
                        tr("new scenario %1").arg(QString::fromStdString(name)), name))
        select(ProjectPart::scenario, name);
}

void ProjectDock::setKind(const std::string& place, PlaceKind kind) {
    session_.change(withPlaceKind(session_.project(), place, kind),
                    tr("change kind of %1").arg(QString::fromStdString(place)));
}

void ProjectDock::askForRoads(const std::string& lot) {
    const auto found = findLot(session_.project(), lot);
    if (!found) return;
    auto* dialog = new LotRoadsDialog(QString::fromStdString(lot), found->roads, this);
    connect(dialog, &QDialog::accepted, this, [this, dialog, lot, before = found->roads] {
        if (!std::ranges::is_permutation(dialog->roads(), before))
            session_.change(withRoads(session_.project(), lot, dialog->roads()),
                            tr("roads along %1").arg(QString::fromStdString(lot)));
    });
    dialog->open();
}

void ProjectDock::editName(ProjectPart part, const std::string& name) {
    for (QWidget* around = parentWidget(); around != nullptr; around = around->parentWidget())
        if (auto* dock = qobject_cast<QDockWidget*>(around)) {
            dock->show();
            dock->raise();
        }
    select(part, name);
    tree_->edit(model_->indexOf(part, name));
}

void ProjectDock::select(ProjectPart part, const std::string& name) {
    const QModelIndex index = model_->indexOf(part, name);
    tree_->setCurrentIndex(index);
    tree_->scrollTo(index);
}

void ProjectDock::showMenu(QPoint at) {
    const QModelIndex index = tree_->indexAt(at);
    const ProjectNode* node = model_->nodeAt(index);
    QMenu menu;
    if (node != nullptr && canRemove(*node))
        addPartActions(menu, index, *node);
    else if (node != nullptr && node->part)
        addGroupActions(menu, *node);
    if (!menu.isEmpty()) menu.exec(tree_->viewport()->mapToGlobal(at));
}

// `index` is persistent, since the project may change while the menu is open.
void ProjectDock::addPartActions(QMenu& menu, const QPersistentModelIndex& index, const ProjectNode& node) {
    if (node.kind == Kind::part) menu.addAction(describeUse(*node.part), this, [this, index] { use(index); });
    if (node.part == ProjectPart::scenario && node.kind == Kind::part) addScenarioActions(menu, node.name);
    if (node.part == ProjectPart::place && node.kind == Kind::part) addPlaceActions(menu, node.name);
    if (node.part == ProjectPart::lot && node.kind == Kind::part) addLotActions(menu, node.name);
    if (node.kind == Kind::part)
        menu.addAction(tr("&Rename\tF2"), this, [this, index] { tree_->edit(index); });
    if (canDuplicate(node)) menu.addAction(tr("D&uplicate"), this, [this, index] { duplicate(index); });
    menu.addAction(node.kind == Kind::edit ? tr("&Remove step\tDel") : tr("&Delete\tDel"), this,
                   [this, index] { remove(index); });
}

void ProjectDock::addScenarioActions(QMenu& menu, const std::string& name) {
    if (name != session_.scenario())
        menu.addAction(tr("&Compare with this"), this, [this, name] { session_.compareWith(name); });
    menu.addAction(tr("&New scenario from this"), this, [this, name] { addScenario(name); });
    QMenu& bases = *menu.addMenu(tr("&Starts from"));
    const auto offer = [&](const std::string& base) {
        bases.addAction(scenarioName(base), this, [this, name, base] {
            session_.change(rebase(session_.project(), name, base),
                            tr("change base of %1").arg(QString::fromStdString(name)));
        });
    };
    offer(existingCity);
    for (const Scenario& other : session_.project().scenarios)
        if (other.name != name) offer(other.name);
    menu.addSeparator();
}

void ProjectDock::addLotActions(QMenu& menu, const std::string& name) {
    menu.addAction(tr("Edit lot &shape"), this, [this, name] {
        if (const auto lot = findLot(session_.project(), name)) Q_EMIT editLotRequested(*lot);
    });
    menu.addAction(tr("R&oads along it..."), this, [this, name] { askForRoads(name); });
}

void ProjectDock::addPlaceActions(QMenu& menu, const std::string& name) {
    menu.addAction(tr("&Use as study region"), this, [this, name] { Q_EMIT useAsRegionRequested(name); });
    QMenu& kinds = *menu.addMenu(tr("&Kind"));
    for (const PlaceKind kind : placeKinds)
        kinds.addAction(describeKind(kind), this, [this, name, kind] { setKind(name, kind); });
}

void ProjectDock::addGroupActions(QMenu& menu, const ProjectNode& node) {
    if (node.part == ProjectPart::scenario) {
        if (node.kind == Kind::part) {
            menu.addAction(tr("&Show"), this, [this] { session_.goTo(existingCity); });
            if (session_.scenario() != existingCity)
                menu.addAction(tr("&Compare with this"), this,
                               [this] { session_.compareWith(existingCity); });
        }
        menu.addAction(tr("&New scenario"), this, [this] { addScenario({}); });
    }
    if (node.part == ProjectPart::region)
        menu.addAction(tr("&Save the study's region"), this, &ProjectDock::saveRegionRequested);
    if (node.part == ProjectPart::period)
        menu.addAction(tr("&Save the study's period"), this, &ProjectDock::savePeriodRequested);
    if (node.part == ProjectPart::view)
        menu.addAction(tr("&Save this view"), this, &ProjectDock::saveViewRequested);
    if (node.part == ProjectPart::result)
        menu.addAction(tr("&Save the displayed result"), this, &ProjectDock::saveResultRequested);
    if (node.part == ProjectPart::lot)
        menu.addAction(tr("&Draw a lot"), this, &ProjectDock::drawLotRequested);
    if (node.part == ProjectPart::place) {
        menu.addAction(tr("&Draw a place"), this, &ProjectDock::drawPlaceRequested);
        menu.addAction(tr("&Read places from a file..."), this, &ProjectDock::readPlacesRequested);
    }
}

}  // namespace noonmark
