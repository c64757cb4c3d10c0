// The option tables of all programs that RADIANCE has too, as their main functions read them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cal/rcalc/settings.h"
#include "rt/programs/rcontrib/settings.h"
#include "rt/programs/rpict_options.h"
#include "rt/programs/rtrace_options.h"
#include "rt/programs/vwrays/settings.h"
#include "scene/getinfo_options.h"
#include "scene/obj2mesh_options.h"
#include "scene/oconv_options.h"
#include "scene/xform/settings.h"

namespace infra {

/// The settings that the tables refer to, and the tables.
struct ProgramTables {
    OconvSettings oconv;
    RpictOptions rpict;
    RtraceOptions rtrace;
    RcontribSettings rcontrib;
    xform::Settings xform;
    GetinfoSettings getinfo;
    VwraysSettings vwrays;
    rcalc::Settings rcalc;
    Obj2meshSettings obj2mesh;

    std::vector<OptionTable> tables;

    ProgramTables() {
        tables.push_back(oconv_option_table(oconv));
        tables.push_back(rpict_option_table(rpict));
        tables.push_back(rtrace_option_table(rtrace));
        tables.push_back(rcontrib_option_table(rcontrib));
        tables.push_back(xform::option_table(xform));
        tables.push_back(getinfo_option_table(getinfo));
        tables.push_back(vwrays_option_table(vwrays));
        tables.push_back(rcalc::option_table(rcalc));
        tables.push_back(obj2mesh_option_table(obj2mesh));
    }
    ProgramTables(const ProgramTables&) = delete;
    ProgramTables& operator=(const ProgramTables&) = delete;
};

}  // namespace infra
