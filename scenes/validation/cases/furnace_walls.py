"""The walls of the furnaces: each reflecting material that there is, as scene text that defines the modifier `m`."""

# Files that the walls need, made beside the scenes: tables of BRDFs by program and arguments, data by their text.
TABLES = {
    "ward.brdf": ("brdftab", "-ward", .2, .3, .25, "-n", 19, 36, 19, "-clamp-energy", "-o", "ward.brdf"),
    "ggx.brdf": ("brdftab", "-ggx", .1, .3, 1.5, 0, "-n", 19, 36, 19, "-clamp-energy", "-o", "ggx.brdf"),
    "paint.brdf": ("brdftab", "-sandford-robertson", .7, .1, .3, .9, "-n", 19, 36, 19, "-symmetrize", "-clamp-energy",
                   "-o", "paint.brdf"),
    "sea.brdf": ("brdftab", "-cox-munk", 5, 1.218, .0508, "-n", 31, 36, 31, "-symmetrize", "-clamp-energy", "-o",
                 "sea.brdf"),
}
DATA = {"steps.dat": "1\n-1 1 5\n.3 .9 .5 .8 .4\n"}


def simple(kind, *numbers):
    return f"void {kind} m\n0\n0\n{len(numbers)} {' '.join(map(str, numbers))}\n"


def table(file, samples=1024):
    return f"void nrlbrdf m\n1 {file}\n0\n5 1 1 1 {samples} .3\n"


STRIPES = "if(sin(9*Px)*sin(7*Py)*sin(5*Pz),.9,.3)"

WALLS = {
    "black": "",
    "plastic, diffuse .9": simple("plastic", .9, .9, .9, 0, 0),
    "plastic, smooth": simple("plastic", .4, .4, .4, .1, 0),
    "plastic, rough .05": simple("plastic", .6, .6, .6, .3, .05),
    "plastic, rough .3": simple("plastic", .6, .6, .6, .3, .3),
    "metal, smooth": simple("metal", .7, .7, .7, .9, 0),
    "metal, rough .05": simple("metal", .6, .6, .6, .8, .05),
    "metal, rough .3": simple("metal", .6, .6, .6, .8, .3),
    "trans, smooth": simple("trans", .7, .7, .7, .1, 0, .5, .5),
    "trans, rough .15": simple("trans", .7, .7, .7, .1, .15, .5, .5),
    "glass": simple("glass", .8, .8, .8),
    "nrlbrdf, Ward": table("ward.brdf"),
    "nrlbrdf, GGX": table("ggx.brdf"),
    "nrlbrdf, Sandford–Robertson": table("paint.brdf"),
    "nrlbrdf, Cox–Munk sea": table("sea.brdf"),
    "mixfunc of mirror and table": "void metal mirror_1\n0\n0\n5 1 1 1 1 0\n\n"
                                   + table("ward.brdf").replace(" m\n", " paint\n")
                                   + "\nvoid mixfunc m\n4 mirror_1 paint .4 .\n0\n0\n",
    "brightfunc on plastic": f"void brightfunc stripes\n2 {STRIPES} .\n0\n0\n\n"
                             "stripes plastic m\n0\n0\n5 .9 .9 .9 .05 .1\n",
    "colorfunc on metal": f"void colorfunc stripes\n4 {STRIPES} {STRIPES} {STRIPES} .\n0\n0\n\n"
                          "stripes metal m\n0\n0\n5 .9 .9 .9 .5 .2\n",
    "texfunc on plastic": "void texfunc waves\n4 .1*sin(20*Px) .1*sin(20*Py) .1*sin(20*Pz) .\n0\n0\n\n"
                          "waves plastic m\n0\n0\n5 .4 .4 .4 .2 0\n",
    "brightdata on trans": "void brightdata steps\n4 noop steps.dat . Pz\n0\n0\n\n"
                           "steps trans m\n0\n0\n7 .8 .8 .8 .1 .1 .4 .3\n",
    "mixdata of glass and plastic": "void glass pane\n0\n0\n3 .8 .8 .8\n\n"
                                    "void plastic paint\n0\n0\n5 .7 .7 .7 .1 .2\n\n"
                                    "void mixdata m\n6 pane paint noop steps.dat . Pz\n0\n0\n",
}

BANDS = (("8 10", "ward.brdf"), ("10 12", "ggx.brdf"))      # µm; joined in bands.brdf

SPECTRAL_WALLS = {
    "spectrum on plastic": "void spectrum hues\n0\n0\n6 8250 11750 .2 .9 .5 .8\n\n"
                           "hues plastic m\n0\n0\n5 .9 .9 .9 .05 .1\n",
    "nrlbrdf of two bands": table("bands.brdf"),
}
