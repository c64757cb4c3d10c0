#include <gtest/gtest.h>

#include "common/error.h"
#include "rt/programs/rpict_options.h"
#include "rt/programs/rtrace_options.h"

namespace infra {
namespace {

using Words = std::vector<std::string>;

constexpr const char* rpict_text =
    "-vtv\t\t\t\t# view type perspective\n"
    "-vp 0.000000 0.000000 0.000000\t# view point\n"
    "-vd 0.000000 1.000000 0.000000\t# view direction\n"
    "-vu 0.000000 0.000000 1.000000\t# view up\n"
    "-vh 45.000000\t\t\t# view horizontal size\n"
    "-vv 45.000000\t\t\t# view vertical size\n"
    "-vo 0.000000\t\t\t# view fore clipping plane\n"
    "-va 0.000000\t\t\t# view aft clipping plane\n"
    "-vs 0.000000\t\t\t# view shift\n"
    "-vl 0.000000\t\t\t# view lift\n"
    "-x  512      \t\t\t# x resolution\n"
    "-y  512      \t\t\t# y resolution\n"
    "-pRGB\t\t\t\t# standard RGB color output\n"
    "-pa 1.000000\t\t\t# pixel aspect ratio\n"
    "-pj 0.670000\t\t\t# pixel jitter\n"
    "-pm 0.000000\t\t\t# pixel motion\n"
    "-pd 0.000000\t\t\t# pixel depth-of-field\n"
    "-ps 4        \t\t\t# pixel sample\n"
    "-pt 0.050000\t\t\t# pixel threshold\n"
    "-t  0        \t\t\t# time between reports\n"
    "-w+\t\t\t\t# warning messages on\n"
    "-i-\t\t\t\t# irradiance calculation off\n"
    "-u-\t\t\t\t# correlated quasi-Monte Carlo sampling\n"
    "-bv+\t\t\t\t# back face visibility on\n"
    "-dt 0.050000\t\t\t# direct threshold\n"
    "-dc 0.500000\t\t\t# direct certainty\n"
    "-dj 0.000000\t\t\t# direct jitter\n"
    "-ds 0.250000\t\t\t# direct sampling\n"
    "-dr 1        \t\t\t# direct relays\n"
    "-dp 512      \t\t\t# direct pretest density\n"
    "-dv+\t\t\t\t# direct visibility on\n"
    "-ss 1.000000\t\t\t# specular sampling\n"
    "-st 0.150000\t\t\t# specular threshold\n"
    "-av 0.000000 0.000000 0.000000\t# ambient value\n"
    "-aw 0        \t\t\t# ambient value weight\n"
    "-ab 0        \t\t\t# ambient bounces\n"
    "-aa 0.200000\t\t\t# ambient accuracy\n"
    "-ar 64       \t\t\t# ambient resolution\n"
    "-ad 512      \t\t\t# ambient divisions\n"
    "-as 128      \t\t\t# ambient super-samples\n"
    "-me 0.00e+00 0.00e+00 0.00e+00\t# mist extinction coefficient\n"
    "-ma 0.000000 0.000000 0.000000\t# mist scattering albedo\n"
    "-mg 0.000000\t\t\t# mist scattering eccentricity\n"
    "-ms 0.000000\t\t\t# mist sampling distance\n"
    "-lr 7        \t\t\t# limit reflection\n"
    "-lw 1.00e-04\t\t\t# limit weight\n"
    "-am 0.0\t\t\t\t# max photon search radius\n"
    "-n 0        \t\t\t# number of threads, 0: all cores\n";

constexpr const char* rtrace_text =
    "-w+\t\t\t\t# warning messages on\n"
    "-n 1 \t\t\t\t# number of rendering processes\n"
    "-x 0        \t\t\t# flush interval\n"
    "-y 0        \t\t\t# y resolution\n"
    "-ld-\t\t\t\t# limit distance off\n"
    "-h+\t\t\t\t# output header\n"
    "-faa\t\t\t\t# format input/output = ascii/ascii\n"
    "-ov        \t\t\t# output value\n"
    "-pRGB\t\t\t\t# standard RGB color output\n"
    "-i-\t\t\t\t# irradiance calculation off\n"
    "-u+\t\t\t\t# uncorrelated Monte Carlo sampling\n"
    "-bv+\t\t\t\t# back face visibility on\n"
    "-dt 0.030000\t\t\t# direct threshold\n"
    "-dc 0.750000\t\t\t# direct certainty\n"
    "-dj 0.000000\t\t\t# direct jitter\n"
    "-ds 0.200000\t\t\t# direct sampling\n"
    "-dr 2        \t\t\t# direct relays\n"
    "-dp 512      \t\t\t# direct pretest density\n"
    "-dv+\t\t\t\t# direct visibility on\n"
    "-ss 1.000000\t\t\t# specular sampling\n"
    "-st 0.150000\t\t\t# specular threshold\n"
    "-av 0.000000 0.000000 0.000000\t# ambient value\n"
    "-aw 0        \t\t\t# ambient value weight\n"
    "-ab 0        \t\t\t# ambient bounces\n"
    "-aa 0.100000\t\t\t# ambient accuracy\n"
    "-ar 256      \t\t\t# ambient resolution\n"
    "-ad 1024     \t\t\t# ambient divisions\n"
    "-as 512      \t\t\t# ambient super-samples\n"
    "-me 0.00e+00 0.00e+00 0.00e+00\t# mist extinction coefficient\n"
    "-ma 0.000000 0.000000 0.000000\t# mist scattering albedo\n"
    "-mg 0.000000\t\t\t# mist scattering eccentricity\n"
    "-ms 0.000000\t\t\t# mist sampling distance\n"
    "-lr -10      \t\t\t# limit reflection (Russian roulette)\n"
    "-lw 1.00e-04\t\t\t# limit weight\n"
    "-am 0.0\t\t\t\t# max photon search radius\n";

template <class Options>
struct Parsed {
    Options options;
    OptionTable table;

    explicit Parsed(Words words) : table(make(options)) { table.parse(std::move(words)); }
    static OptionTable make(RpictOptions& options) { return rpict_option_table(options); }
    static OptionTable make(RtraceOptions& options) { return rtrace_option_table(options); }
};

template <class Options>
std::string refusal(Words words) {
    try {
        Parsed<Options> parsed(std::move(words));
    } catch (const Error& error) {
        return error.what();
    }
    return "taken";
}

TEST(Options, list_radiances_defaults) {
    EXPECT_EQ(Parsed<RpictOptions>({}).table.defaults(), rpict_text);
    EXPECT_EQ(Parsed<RtraceOptions>({}).table.defaults(), rtrace_text);
}

TEST(Options, defaults_follow_what_was_given) {
    const std::string text =
        Parsed<RtraceOptions>({"-x", "3", "-y", "2", "-h", "-fad", "-otLs", "-lr", "5"}).table.defaults();
    for (const char* line : {"-x 3        \t\t\t# x resolution\n", "-h-\t\t\t\t# no header\n",
                             "-fad\t\t\t\t# format input/output = ascii/double\n",
                             "-otLs      \t\t\t# output trace first_length surface\n",
                             "-lr 5        \t\t\t# limit reflection\n"})
        EXPECT_NE(text.find(line), text.npos) << line << text;
}

TEST(Options, set_what_they_say) {
    const Parsed<RpictOptions> parsed(
        {"-ab", "2", "-av", ".1", ".2", ".3", "-u+", "-bv-", "-dv-", "-i", "-w-", "-ps", "1"});
    const RenderOptions& render = parsed.options.render;
    EXPECT_EQ(render.settings.ambient_bounces, 2);
    EXPECT_FLOAT_EQ(render.settings.ambient_value[2], .3f);
    EXPECT_TRUE(render.uncorrelated);
    EXPECT_FALSE(render.settings.back_faces_visible);
    EXPECT_FALSE(render.settings.sources_visible);
    EXPECT_TRUE(render.settings.irradiance);
    EXPECT_FALSE(render.warnings);
    EXPECT_EQ(parsed.options.sample_spacing, 1);
}

TEST(Options, e_defines_functions_or_names_the_error_file) {
    const Parsed<RtraceOptions> parsed({"-e", "a=1", "-f", "more.cal", "-e", "b:2", "-e", "log", "-fd"});
    const RenderOptions& render = parsed.options.render;
    ASSERT_EQ(render.definitions.size(), 3u);
    EXPECT_EQ(render.definitions[0].text, "a=1");
    EXPECT_TRUE(render.definitions[1].is_file);
    EXPECT_EQ(render.definitions[2].text, "b:2");
    EXPECT_EQ(render.error_file, "log");
    EXPECT_EQ(parsed.options.input, NumberFormat::doubles);
    EXPECT_EQ(parsed.options.output, NumberFormat::doubles);
}

TEST(Options, filters_keep_the_last_kind) {
    const Parsed<RtraceOptions> parsed({"-ai", "a", "-ae", "b", "-ae", "c", "-ti", "d"});
    const NameFilter& ambient = parsed.options.render.settings.ambient_filter;
    EXPECT_EQ(ambient.mode, NameFilter::Mode::exclude);
    EXPECT_EQ(ambient.names, (Words{"b", "c"}));
    EXPECT_EQ(parsed.options.tree_filter.mode, NameFilter::Mode::include);
}

TEST(Options, of_mist_are_numbers_of_any_size) {
    const Parsed<RpictOptions> parsed(
        {"-me", "0", "1e-9", "2e9", "-ma", ".1", ".2", ".3", "-mg", ".4", "-ms", "5"});
    const RenderSettings& settings = parsed.options.render.settings;
    EXPECT_EQ(settings.extinction[1], 1e-9f);
    EXPECT_EQ(settings.extinction[2], 2e9f);
    EXPECT_EQ(settings.scattering_albedo[2], .3f);
    EXPECT_EQ(settings.scattering_eccentricity, .4);
    EXPECT_EQ(settings.medium_step, 5);
}

TEST(Options, of_sequences_and_recovery_are_read) {
    const Parsed<RpictOptions> parsed({"-S", "12", "-ro", "a%d.hdr", "-pm", ".5", "-pd", ".25", "-PP", "p"});
    EXPECT_EQ(parsed.options.first_number, 12);
    EXPECT_TRUE(parsed.options.is_sequence());
    EXPECT_EQ(parsed.options.recover, "a%d.hdr");
    EXPECT_EQ(parsed.options.output, "a%d.hdr");
    EXPECT_EQ(parsed.options.motion_blur, .5);
    EXPECT_EQ(parsed.options.lens_diameter, .25);
    EXPECT_EQ(parsed.options.render.persist_file, "p");
    EXPECT_FALSE(Parsed<RpictOptions>({"-S", "0"}).options.is_sequence());
    EXPECT_FALSE(Parsed<RpictOptions>({"-S", "-3"}).options.is_sequence());
}

TEST(Options, of_channels_and_colors_are_listed_as_radiance_does) {
    struct Case {
        Words words;
        Words there, absent;
    };
    const std::string rgb = "-pRGB\t\t\t\t# standard RGB color output\n";
    const std::string spectra = "-co+\t\t\t\t# output spectral values\n";
    const std::string colors = "-co-\t\t\t\t# output tristimulus colors\n";
    const std::string bins = "-cs 8 \t\t\t\t# number of spectral bins\n";
    const Case cases[] = {
        {{"-cs", "8"}, {rgb, colors, bins, "-cw 380 780\t\t\t# wavelength limits (nm)\n"}, {}},
        {{"-cs", "8", "-co"}, {spectra, bins}, {"-pRGB"}},
        {{"-cs", "8", "-cw", "900", "300"}, {"-cw 300 900\t\t\t# wavelength limits (nm)\n"}, {}},
        {{"-cs", "8", "-pXYZ"}, {"-pXYZ\t\t\t\t# CIE XYZ color output\n", colors}, {"-pRGB"}},
        {{"-cs", "8", "-pY"}, {"-pY\t\t\t\t# photopic output\n"}, {"-pRGB", "-co"}},
        {{"-cs", "8", "-pY", "-co"}, {spectra}, {"-pY"}},
        {{"-cs", "8", "-pY", "-co-"}, {"-pY\t"}, {"-co"}},
        {{"-co+"}, {}, {"-co", "-cs", "-cw"}},
        {{"-pc", ".7", ".3", ".2", ".7", ".13", ".05", ".31", ".33"},
         {"-pc 0.7000 0.3000 0.2000 0.7000 0.1300 0.0500 0.3100 0.3300\t"
          "# output color primaries and white point\n"},
         {"-pRGB"}},
        {{"-pc", ".6401", ".33", ".29", ".6", ".15", ".06", ".3333", ".3333"}, {rgb}, {"-pc"}},
        {{"-fac", "-cs", "8", "-co"}, {"format input/output = ascii/Radiance_spectra\n"}, {}},
    };
    for (const Case& given : cases) {
        const std::string text = Parsed<RtraceOptions>(given.words).table.defaults();
        for (const std::string& line : given.there) EXPECT_NE(text.find(line), text.npos) << line << text;
        for (const std::string& start : given.absent)
            EXPECT_EQ(text.find("\n" + start), text.npos) << start << text;
    }
    EXPECT_EQ(Parsed<RpictOptions>({"-cs", "8", "-co"}).table.defaults().find("\n-co"), std::string::npos);
}

TEST(Options, of_channels_and_colors_refuse_what_makes_no_sense) {
    EXPECT_NE(refusal<RtraceOptions>({"-cs", "2"}), "taken");
    EXPECT_EQ(refusal<RtraceOptions>({"-pc", "1", "1", "1", "1", "1", "1", ".3", ".3"}),
              "command line error at '-pc 1 1 1 1 1 1 .3 .3': illegal primary chromaticities "
              "(x and y of red, green, blue and white, which must differ and span colors)");
}

TEST(Options, that_radiance_has_and_we_have_not_are_refused_by_name) {
    const auto expect_refused = [](const std::string& text, const std::string& option) {
        EXPECT_TRUE(text.starts_with("command line error at '" + option + "': option is not supported ("))
            << text;
    };
    expect_refused(refusal<RpictOptions>({"-features"}), "-features");
    expect_refused(refusal<RtraceOptions>({"-features"}), "-features");
}

TEST(Options, name_photon_maps_with_up_to_two_bandwidths) {
    const auto settings = [](std::vector<std::string> words) {
        return Parsed<RpictOptions>(std::move(words)).options.render.settings;
    };
    const RenderSettings given =
        settings({"-ap", "a.gpm", "-ap", "b.gpm", "50", "-ap", "c.cpm", "20", "60", "-am", ".25"});
    ASSERT_EQ(given.photon_maps.size(), 3u);
    EXPECT_EQ(given.photon_maps[0].file, "a.gpm");
    EXPECT_EQ(given.photon_maps[0].most, 0);
    EXPECT_EQ(given.photon_maps[1].fewest, 50);
    EXPECT_EQ(given.photon_maps[1].most, 50);
    EXPECT_EQ(given.photon_maps[2].fewest, 20);
    EXPECT_EQ(given.photon_maps[2].most, 60);
    EXPECT_EQ(given.photon_radius, 0.25);
    EXPECT_EQ(given.ambient_bounces, 1);  // the first map turns them on
    EXPECT_EQ(settings({"-ap", "a", "9", "-ab", "0"}).ambient_bounces, 0);
    EXPECT_EQ(settings({"-ab", "-1", "-ap", "a", "9"}).ambient_bounces, -1);
    EXPECT_EQ(settings({"-ab", "3", "-ap", "a", "9"}).ambient_bounces, 3);

    EXPECT_EQ(refusal<RpictOptions>({"-ap"}),
              "command line error at '-ap': needs an argument (usage: -ap file [bandwidth [largest]])");
    EXPECT_NE(refusal<RtraceOptions>({"-ap", "a", "0"}).find("must be at least 1"), std::string::npos);
    EXPECT_NE(refusal<RtraceOptions>({"-ap", "a", "20", "20"}).find("must be above the first"), std::string::npos);
    EXPECT_NE(refusal<RtraceOptions>({"-am", "0"}).find("must be above 0"), std::string::npos);
    EXPECT_NE(refusal<RtraceOptions>({"-ac", "0"}).find("must be above 0"), std::string::npos);
    EXPECT_EQ(refusal<RtraceOptions>({"-ac", "4", "-aC", "10k"}), "taken");
    EXPECT_NE(Parsed<RtraceOptions>({}).table.defaults().find("-am 0.0\t\t\t\t# max photon search radius\n"),
              std::string::npos);
}

TEST(Options, that_make_no_sense_are_refused) {
    EXPECT_TRUE(refusal<RtraceOptions>({"-zz"}).starts_with("command line error at '-zz': unknown option"));
    EXPECT_NE(refusal<RtraceOptions>({"-fcc"}), "taken");
    EXPECT_NE(refusal<RtraceOptions>({"-fx"}), "taken");
    EXPECT_NE(refusal<RtraceOptions>({"-n", "0"}), "taken");
    EXPECT_NE(refusal<RpictOptions>({"-x", "0"}), "taken");
    EXPECT_NE(refusal<RpictOptions>({"-ab", "x"}), "taken");
    EXPECT_NE(refusal<RtraceOptions>({"-tI", "no_such_list_of_names"}), "taken");
}

TEST(RtraceOptions, tell_when_to_flush_and_to_stop) {
    const auto given = [](int width, int height) {
        RtraceOptions options;
        options.width = width;
        options.height = height;
        return std::pair(options.flush_interval(), options.ray_limit());
    };
    using Pair = std::pair<std::uint64_t, std::uint64_t>;
    EXPECT_EQ(given(0, 0), Pair(0, 0));
    EXPECT_EQ(given(3, 0), Pair(3, 0));
    EXPECT_EQ(given(3, 2), Pair(0, 6));
    EXPECT_EQ(given(0, 2), Pair(0, 2));
    EXPECT_EQ(given(1, 2), Pair(1, 2));
}

TEST(OutputSpec, refuses_combinations_without_sense) {
    const auto complaint = [](Words words) -> std::string {
        const Parsed<RtraceOptions> parsed(std::move(words));
        std::string warned;
        try {
            output_spec(parsed.options, [&](std::string_view text) { warned += text; });
        } catch (const Error& error) {
            return error.message();
        }
        return warned;
    };
    EXPECT_EQ(complaint({"-ovn"}), "");
    EXPECT_EQ(complaint({"-ffc", "-ovn"}), "color format only with -ov, -or, -ox");
    EXPECT_EQ(complaint({"-ffc", "-or"}), "");
    EXPECT_EQ(complaint({"-ffc", "-pS"}), "color format incompatible with -pY, -pS, -pM, -pA");
    EXPECT_EQ(complaint({"-oL", "-I"}), "-I+ and -i+ options require some value output");
    EXPECT_EQ(complaint({"-oL", "-i"}), "-I+ and -i+ options require some value output");
    EXPECT_EQ(complaint({"-oV"}), "-oVW options require trace mode");
    EXPECT_EQ(complaint({"-otV"}), "");
    EXPECT_EQ(complaint({"-or", "-i"}), "-orRxX options incompatible with -I+ and -i+");
}

}  // namespace
}  // namespace infra
