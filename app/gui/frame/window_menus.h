#pragma once

#include <QList>

class QToolBar;
class QAction;
class QMenu;
class QMenuBar;

namespace noonmark {

struct WindowActions;

/// Arranges the entries that are used most as icons.
void fillToolBar(QToolBar& bar, const WindowActions& actions);

class CopyActions;
class EditActions;
class HelpActions;
class MovieActions;
class OpeningActions;
class PhotographActions;
class PlaceActions;
class RegionActions;
class PreferencesActions;
class ResultActions;
class ReviewActions;
class SavedViews;
class SavingActions;
class ScenarioActions;
class SearchActions;
class StudyActions;
class TourActions;
class TowerDisplay;
class ViewActions;
class ViewPresets;

/// The entries of the menus. Their owners make and connect them.
struct WindowActions {
    const OpeningActions& opening;
    const SavingActions& saving;
    const ResultActions& results;
    const MovieActions& movies;
    const CopyActions& copying;
    const EditActions& edits;
    const ScenarioActions& scenarios;
    const StudyActions& study;
    const RegionActions& region;
    const PlaceActions& places;
    const PhotographActions& photograph;
    const ReviewActions& review;
    const ViewActions& view;
    const ViewPresets& presets;
    const SavedViews& savedViews;
    const SearchActions& search;
    const PreferencesActions& preferences;
    const HelpActions& help;
    const TourActions& tours;
    const TowerDisplay& towers;
    QMenu* themes;
    QList<QAction*> comparing;  ///< two scenarios in the view
    QList<QAction*> modes;
    QList<QAction*> docks;  ///< each shows and hides a dock
    QList<QAction*> sun;    ///< plays and moves the sun
    QAction* sunDome;
};

/// Creates the menus and arranges the entries in them. Returns the entry that quits, for the window to
/// connect.
QAction* fillMenus(QMenuBar& bar, const WindowActions& actions);

}  // namespace noonmark
