DefineConstant[ width = 2, Height = 1, rad = 0.1 ];
side = 3;
Point(1) = {0, 0, 0, 0.5};
Extrude{width, 0, 0}{ Point{1}; Layers{2}; }
Extrude{0, Height, 0}{ Curve{1}; Layers{2}; Recombine; }
Physical Surface("BODY") = {5};
Physical Curve("LOW") = {1};
