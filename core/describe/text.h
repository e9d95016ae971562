#pragma once

/// Marks a text of core that the GUI shows in the user's language; core and the command line use it as it
/// stands, in English. lupdate reads the macro (app/CMakeLists.txt), in the context "noonmark".
#define NM_TEXT(text) text
