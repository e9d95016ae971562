#include "app/gui/session/study/engine_words.h"

#include <QCoreApplication>
#include <string>

namespace noonmark {

namespace {

// What core/engines and render/gl write.
[[maybe_unused]] constexpr const char* engineWords[] = {
    QT_TRANSLATE_NOOP("Engine", "Ray reference"),
    QT_TRANSLATE_NOOP(
        "Engine",
        "One ray per receiver and step, traced by Embree: the truth that others are measured against"),
    QT_TRANSLATE_NOOP("Engine", "Projected shadows"),
    QT_TRANSLATE_NOOP(
        "Engine", "Each building's shadow filled as polygons at every step: exact and fast on flat ground"),
    QT_TRANSLATE_NOOP("Engine", "Horizon sweep"),
    QT_TRANSLATE_NOOP("Engine",
                      "The slope of each receiver's horizon, azimuth by azimuth: a year in moments, on "
                      "terrain and roofs too"),
    QT_TRANSLATE_NOOP("Engine", "Shadow accrual map"),
    QT_TRANSLATE_NOOP("Engine",
                      "A depth map of each step of an hour, drawn from a city placed once; hours that look "
                      "alike computed once"),
    QT_TRANSLATE_NOOP("Engine", "Inverse accrual map"),
    QT_TRANSLATE_NOOP("Engine",
                      "Occluders at both ends of each hour, their shadows moved along straight lines "
                      "between; hours that look alike computed once"),
    QT_TRANSLATE_NOOP("Engine", "Ray reference through the direction graph"),
    QT_TRANSLATE_NOOP("Engine",
                      "Rays, with hours that look alike traced once: what the graph alone does to the error"),
    QT_TRANSLATE_NOOP("Engine", "Automatic"),
    QT_TRANSLATE_NOOP("Engine",
                      "Projected shadows, the horizon sweep or rays: the exact one where it is quick, and "
                      "the result says which and why"),
    QT_TRANSLATE_NOOP("Engine", "Shadow maps (OpenGL)"),
    QT_TRANSLATE_NOOP("Engine",
                      "Draws one depth map per step and tests every cell against it: the method that the "
                      "paper compares accrual maps with"),
    QT_TRANSLATE_NOOP("Engine", "Shadow accrual map (OpenGL)"),
    QT_TRANSLATE_NOOP("Engine",
                      "One draw on the graphics device fills the depth maps of all steps of an hour"),
    QT_TRANSLATE_NOOP("Engine", "Error target"),
    QT_TRANSLATE_NOOP("Engine",
                      "Mean error of a cell's gross shadow, of the period: the sweep's azimuth bins are as "
                      "wide as it lets them be; half of it takes twice as long"),
    QT_TRANSLATE_NOOP("Engine", "Azimuth bin"),
    QT_TRANSLATE_NOOP(
        "Engine",
        "Suns whose azimuth is less than this apart share one horizon; 0: as the error target asks"),
    QT_TRANSLATE_NOOP("Engine", "Continuous shadow"),
    QT_TRANSLATE_NOOP(
        "Engine",
        "The longest unbroken shadow is counted too; without it, gross shadow only, in about half the time"),
    QT_TRANSLATE_NOOP("Engine", "Check runs"),
    QT_TRANSLATE_NOOP(
        "Engine",
        "Rays look at every step of every longest run, so that a gap between two walls in"
        " one line is found too; without it, they look at what neighbouring bins leave in doubt"),
    QT_TRANSLATE_NOOP("Engine", "Map size"),
    QT_TRANSLATE_NOOP("Engine",
                      "Texels along a side of the depth map that is stretched over the region; no more than "
                      "cells are used"),
    QT_TRANSLATE_NOOP("Engine", "Bias"),
    QT_TRANSLATE_NOOP("Engine", "How high above the ground something must be to shade it"),
    QT_TRANSLATE_NOOP("Engine", "Interval"),
    QT_TRANSLATE_NOOP("Engine", "How long the sun is taken to move in a straight line"),
    QT_TRANSLATE_NOOP("Engine", "Direction bound"),
    QT_TRANSLATE_NOOP("Engine", "Hours whose sun is less than this apart are computed once"),
    QT_TRANSLATE_NOOP("Engine", "Source levels"),
    QT_TRANSLATE_NOOP("Engine", "How many occluders, nearest first, are followed from each cell"),
    QT_TRANSLATE_NOOP("Engine", "Sources by rays"),
    QT_TRANSLATE_NOOP(
        "Engine",
        "Embree finds the occluders at an interval's ends; otherwise filled polygons do, which is faster"),
    QT_TRANSLATE_NOOP("Engine", "Nearest hit"),
    QT_TRANSLATE_NOOP("Engine", "Occluders nearer to a cell than this are left out (the paper: 1 m)"),
    QT_TRANSLATE_NOOP("Engine", "OpenCL device"),
    QT_TRANSLATE_NOOP("Engine", "Which OpenCL device draws, counted from 0; -1: the processor itself"),
    QT_TRANSLATE_NOOP("Engine", "yes"),
    QT_TRANSLATE_NOOP("Engine", "no")};

}  // namespace

QString translateEngineWord(std::string_view english) {
    return QCoreApplication::translate("Engine", std::string(english).c_str());
}

}  // namespace noonmark
